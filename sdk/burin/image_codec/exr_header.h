#pragma once
#include <cstdint>
#include <filesystem>

namespace burin {

/// Checks the sizes in the header of an EXR file. OpenEXR allocates memory for the offsets of all chunks and
/// for the texels of a chunk by the header alone, before it reads the image. Throws FileError if that is more
/// than a file of this size may ask for (check_stamp_size), or if the header is damaged or incomplete.
/// [openexr.com, OpenEXR File Layout]
void check_exr_header(const std::filesystem::path& path, std::uint64_t file_bytes);

}  // namespace burin
