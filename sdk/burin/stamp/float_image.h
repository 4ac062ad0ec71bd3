#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin {

/// An image of measured values, rows from the top.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< their names: {"Y"}, {"R", "G", "B"}
  std::vector<float> texels;          ///< width * height * channels, interleaved
};

/// Writes an EXR file of 32-bit floats, whole or not at all. Throws FileError, and ContractError for an image
/// without texels or with another number of values.
void write_exr(const std::filesystem::path& path, const FloatImage& image);

}  // namespace burin
