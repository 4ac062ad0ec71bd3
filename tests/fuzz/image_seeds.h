#pragma once
#include <filesystem>
#include <vector>

namespace burin::fuzz {

/// Small images of every kind that stamps are, in the format of the extension (.exr, .png, .tif, .jpg).
/// Returns the files.
std::vector<std::filesystem::path> write_image_seeds(const std::string& extension,
                                                     const std::filesystem::path& folder);

}  // namespace burin::fuzz
