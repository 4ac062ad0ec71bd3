#pragma once
#include <filesystem>

namespace burin::samples {

/// Writes a vector displacement map of a thorn that bends to the right until its tip points down: 96 x 96
/// texels of three half-float channels. It moves the point (x, y) of the stamp, x from -1 on the left to 1
/// and y from -1 below to 1, to (x + red, y + green, blue). The map is 0 outside a disc of radius 0.96.
/// Throws FileError.
void write_thorn(const std::filesystem::path& path);

}  // namespace burin::samples
