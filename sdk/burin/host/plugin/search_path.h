#pragma once
#include <filesystem>
#include <vector>

namespace burin {

/// The folders that the environment variable BURIN_PLUGIN_PATH names, in its order.
std::vector<std::filesystem::path> plugin_search_path();

/// The `*.burin` files of a folder, by name. Throws FileError when the folder cannot be read.
std::vector<std::filesystem::path> plugin_files(const std::filesystem::path& folder);

}  // namespace burin
