#pragma once
#include <burin/stamp/files/stamp_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// The channels that a stamp is made of, all of one part of its file. EXR files have one part or more, others
/// have one.
struct ChosenChannels {
  std::size_t part = 0;                    ///< index of the part
  std::vector<int> channels;               ///< numbers within the part
  std::vector<std::string> names, unused;  ///< names of these channels, and of all others of the file
};

/// Chooses channels by the options, see choose_channels(). `parts`: [part] names of its channels. Throws
/// FileError, which names `path`, for all reasons of choose_channels() and for channels of several parts.
ChosenChannels chosen_channels(const std::string& path, const std::vector<std::vector<std::string>>& parts,
                               const StampOptions& options);

/// Returns the texels of the given channels in their order, interleaved. `values` has `stored` channels per
/// texel, the first of which is the file's channel `first`.
std::vector<float> texels_of(const std::vector<int>& channels, std::vector<float> values, std::size_t stored,
                             int first = 0);

}  // namespace burin
