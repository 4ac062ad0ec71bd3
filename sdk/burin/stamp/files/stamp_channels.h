#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// The channels of a file that a stamp is made of, as indices into the list of names.
struct ChannelChoice {
  std::vector<std::size_t> used;    ///< 1: heights; 3: x, y, z; 4: x, y, z, alpha
  std::vector<std::size_t> unused;  ///< the other channels, in the order of the file
};

/// Chooses channels by their names. A name is LAYER.CHANNEL, or CHANNEL alone, which belongs to the layer "".
/// From one layer the function chooses, whatever the order and case of names, the first that exists of:
/// - the only channel;
/// - three channels whose names are r, g, b or red, green, blue or x, y, z, alone or after a common prefix
///   ("dispR", "disp.x"), together with the alpha of that prefix; names without a prefix come first;
/// - the only channel besides alpha (A, alpha);
/// - Y, the luminance.
/// `layer`: the layer to choose from: its full name, or the first or last words of its name, up to a dot, if
/// only one layer matches. Empty: the layer "" if it has channels, else the only layer.
/// `channel`: the name of one channel, or of three or four separated by commas, in full or within the layer,
/// which overrides the choice.
/// Throws Error that lists what the file has, if a layer or channel does not exist, several match or none
/// does, and for luminance with chroma (RY, BY), which are neither heights nor vectors.
ChannelChoice choose_channels(const std::vector<std::string>& names, const std::string& layer = {},
                              const std::string& channel = {});

}  // namespace burin
