#pragma once
#include <string>

namespace burin {

/// Throws FileError when a file cannot come into being at `path` (check_output): said before long work, not
/// after it. An empty path is no file.
void check_output_path(const std::string& path);

}  // namespace burin
