#pragma once
#include <burin/base/float_image.h>

#include <filesystem>

// May be called on any thread, also on several at once for different files.
namespace burin {

/// Writes an EXR file of 32-bit floats, whole or not at all. Throws FileError, and ContractError for an image
/// without texels or with another number of values.
void write_exr(const std::filesystem::path& path, const FloatImage& image);

}  // namespace burin
