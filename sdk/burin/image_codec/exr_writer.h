#pragma once
#include <burin/base/float_image.h>

#include <filesystem>

namespace burin {

/// Writes an image that has texels, as write_exr() does.
void write_exr_file(const std::filesystem::path& path, const FloatImage& image);

}  // namespace burin
