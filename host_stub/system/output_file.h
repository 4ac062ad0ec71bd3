#pragma once
#include <string>

namespace burin {

/// Throws FileError if no file can be created at `path` (check_output), so that a bad path fails before the
/// work starts. An empty path is ignored.
void check_output_path(const std::string& path);

}  // namespace burin
