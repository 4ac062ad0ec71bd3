#pragma once
#include <filesystem>
#include <vector>

namespace burin {

/// The folders in which this system keeps fonts, the user's own first.
std::vector<std::filesystem::path> system_font_folders();

/// Returns `font` if that is a file. Else, if it is a bare file name, searches the folders and the folders
/// below them, and returns the first match (in the order of paths) of the first folder that has one. Throws
/// FileError that names the folders.
std::filesystem::path find_font(const std::filesystem::path& font,
                                const std::vector<std::filesystem::path>& folders = system_font_folders());

}  // namespace burin
