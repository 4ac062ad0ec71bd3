#pragma once
#include <filesystem>

namespace burin::samples {

/// Writes a tileable height image of overlapping rounded scales, 256 x 256 texels of one half-float
/// channel, heights 0..1 with free edges towards +u (right). The pattern repeats every 64 texels in both
/// directions and under the shift by (32, 32). Throws FileError.
void write_scales(const std::filesystem::path& path);

}  // namespace burin::samples
