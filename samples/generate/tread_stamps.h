#pragma once
#include <filesystem>

namespace burin::samples {

/// Writes three height images of a tyre's tread, 128 x 128 texels of one half-float channel, heights 0..1.
/// tread.exr repeats in the direction of u (to the right). tread_start.exr and tread_end.exr have a rounded
/// border on the left and on the right, and join to tread.exr without a seam. Throws FileError.
void write_treads(const std::filesystem::path& folder);

}  // namespace burin::samples
