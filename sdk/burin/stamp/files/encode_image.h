#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace burin {

/// Writes an image file in the format with this OpenImageIO name, whole or not at all. `spec` describes the
/// layout of `texels`. Throws FileError.
void write_encoded(const std::filesystem::path& path, const char* format, const OIIO::ImageSpec& spec,
                   const void* texels);

}  // namespace burin
