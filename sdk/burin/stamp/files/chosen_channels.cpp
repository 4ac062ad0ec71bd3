// Chooses the channels of a stamp among those of all parts of a file, and takes their texels.
#include <burin/base/error.h>
#include <burin/stamp/files/chosen_channels.h>
#include <burin/stamp/files/stamp_channels.h>

namespace burin {

ChosenChannels chosen_channels(const std::string& path, const std::vector<std::vector<std::string>>& parts,
                               const StampOptions& options) {
  std::vector<std::string> names;
  for (const std::vector<std::string>& part : parts) names.insert(names.end(), part.begin(), part.end());
  ChannelChoice choice;
  try {
    choice = choose_channels(names, options.layer, options.channel);
  } catch (const Error& error) {
    throw FileError(path, error.what());
  }
  ChosenChannels chosen;
  for (const std::size_t i : choice.unused) chosen.unused.push_back(names[i]);
  for (const std::size_t i : choice.used) {
    std::size_t channel = i, part = 0;
    for (; channel >= parts[part].size(); ++part) channel -= parts[part].size();
    if (!chosen.channels.empty() && part != chosen.part)
      throw FileError(path, "the channels lie in different parts of the file");
    chosen.part = part;
    chosen.channels.push_back(static_cast<int>(channel));
    chosen.names.push_back(names[i]);
  }
  return chosen;
}

std::vector<float> texels_of(const std::vector<int>& channels, std::vector<float> values, std::size_t stored,
                             int first) {
  bool all = channels.size() == stored;
  for (std::size_t i = 0; i < channels.size(); ++i) all = all && channels[i] == first + static_cast<int>(i);
  if (all) return values;
  std::vector<float> chosen;
  chosen.reserve(values.size() / stored * channels.size());
  for (std::size_t texel = 0; texel < values.size(); texel += stored)
    for (const int channel : channels)
      chosen.push_back(values[texel + static_cast<std::size_t>(channel - first)]);
  return chosen;
}

}  // namespace burin
