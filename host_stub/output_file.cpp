#include "output_file.h"

#include <burin/base/error.h>

#include <filesystem>

namespace burin {
namespace fs = std::filesystem;

void check_output_path(const std::string& path) {
  if (path.empty()) return;
  std::error_code error;
  if (fs::is_directory(path, error)) throw FileError(path, "is a folder, not a file");
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder, error)) throw FileError(path, "there is no folder " + folder.string());
}

}  // namespace burin
