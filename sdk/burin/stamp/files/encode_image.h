#pragma once
#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace burin {

/// Writes an image file of the format that OpenImageIO knows by this name, whole or not at all. `texels` are
/// as `spec` describes them. Throws FileError.
void write_encoded(const std::filesystem::path& path, const char* format, const OIIO::ImageSpec& spec,
                   const void* texels);

}  // namespace burin
