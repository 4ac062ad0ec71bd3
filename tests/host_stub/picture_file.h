#pragma once
#include <burin/stamp/files/picture.h>

#include <array>
#include <filesystem>

namespace burin::test {

/// Reads back a PNG of three channels.
Picture read_png(const std::filesystem::path& path);

using Rgb = std::array<int, 3>;

/// sRGB bytes; column and row from the top left.
Rgb pixel(const Picture& picture, int column, int row);

/// Whether something stands before the ground at this pixel; column 0 must show the ground.
bool covered(const Picture& picture, int column, int row);

}  // namespace burin::test
