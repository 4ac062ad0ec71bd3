#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// Which of a file's channels a stamp is made of.
struct ChannelChoice {
  std::vector<std::size_t> used;    ///< 1: heights; 3: x, y, z; 4: with alpha besides. In this order
  std::vector<std::size_t> unused;  ///< the others, as the file has them
};

/// Chooses among the names of a file's channels. A name is LAYER.CHANNEL, or CHANNEL alone, which is of the
/// layer "". Of one layer a stamp takes, whatever the order and case of names:
/// - the only channel there is, or the only one besides alpha (A, alpha);
/// - three that are named, or whose names end in, r, g, b or red, green, blue or x, y, z behind the same
///   prefix, with the alpha of that prefix: "dispR", "disp.x"; without a prefix before others with one;
/// - else Y, the luminance.
/// `layer`: whose channels count; the layer itself, or the only one whose name has these words at its begin
/// or end, up to a point. Empty: "" where it has channels, else the only layer.
/// `channel`: instead of all that, the name of one channel, or of three or four between commas, in full or
/// within the layer.
/// Throws Error, naming what there is: no such layer or channel, several that fit, none that does; luminance
/// and chroma (RY, BY), which are neither heights nor vectors.
ChannelChoice choose_channels(const std::vector<std::string>& names, const std::string& layer = {},
                              const std::string& channel = {});

}  // namespace burin
