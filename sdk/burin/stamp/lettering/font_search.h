#pragma once
#include <filesystem>
#include <vector>

namespace burin {

/// Where this system keeps fonts, the user's own first.
std::vector<std::filesystem::path> system_font_folders();

/// `font` itself where that is a file; else, where it is a mere name, the file of that name in or below one
/// of the folders: of the first that has one, the first in the order of paths. Throws FileError naming the
/// folders.
std::filesystem::path find_font(const std::filesystem::path& font,
                                const std::vector<std::filesystem::path>& folders = system_font_folders());

}  // namespace burin
