#pragma once
#include <string>
#include <vector>

namespace burin {

/// An image of floating-point values, rows from the top.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< names of the channels: {"Y"}, {"R", "G", "B"}
  std::vector<float> texels;          ///< width * height * channels, interleaved
};

}  // namespace burin
