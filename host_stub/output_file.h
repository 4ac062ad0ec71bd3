#pragma once
#include <string>

namespace burin {

/// Throws FileError when a file cannot come into being at `path` since its folder is missing or a folder
/// stands there: said before long work, not after it. An empty path is no file.
void check_output_path(const std::string& path);

}  // namespace burin
