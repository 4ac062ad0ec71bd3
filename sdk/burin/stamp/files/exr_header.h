#pragma once
#include <cstdint>
#include <filesystem>

namespace burin {

/// OpenEXR asks for memory as a file's header tells it, before anything of the image is read: for the places
/// of all chunks, and for a chunk's texels. Throws FileError where that is more than a file of this size may
/// ask for (expect_stamp_size), or where the header has no end. [openexr.com, OpenEXR File Layout]
void expect_exr_header(const std::filesystem::path& path, std::uint64_t file_bytes);

}  // namespace burin
