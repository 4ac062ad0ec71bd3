#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin::samples {

/// Writes an EXR image of half-float texels, row by row from the top, the channels of a texel together. The
/// same texels give the same file every time. Throws FileError.
void write_exr(const std::filesystem::path& path, int width, int height,
               const std::vector<std::string>& channels, std::span<const float> texels);

}  // namespace burin::samples
