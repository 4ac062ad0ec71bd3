#pragma once
#include <burin/base/float_image.h>

#include <filesystem>

namespace burin {

/// Writes an EXR file of 32-bit floats, whole or not at all. Throws FileError, and ContractError for an image
/// without texels or with another number of values.
void write_exr(const std::filesystem::path& path, const FloatImage& image);

}  // namespace burin
