#pragma once
#include <filesystem>
#include <vector>

namespace burin {

/// The folders in the environment variable BURIN_PLUGIN_PATH, in its order.
std::vector<std::filesystem::path> plugin_search_path();

/// The `*.burin` files of a folder, sorted by name. Throws FileError if the folder cannot be read.
std::vector<std::filesystem::path> plugin_files(const std::filesystem::path& folder);

/// The shared libraries of a folder that export a plugin but are not named `*.burin`, sorted by name. They
/// are not loaded to find out. Throws FileError if the folder cannot be read.
std::vector<std::filesystem::path> misnamed_plugins(const std::filesystem::path& folder);

}  // namespace burin
