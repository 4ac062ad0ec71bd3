// Makes the folders of reports, and writes their files.
#include "report/report_folder.h"

#include <burin/base/error.h>
#include <burin/base/file.h>

namespace burin {
namespace fs = std::filesystem;

void check_report_folder(const std::string& folder) {
  std::error_code ignored;
  if (!folder.empty() && fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) {
    throw FileError(folder, "is a file, not a folder");
  }
}

void make_report_folder(const std::string& folder) {
  if (folder.empty()) return;  // the empty path is the current folder
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, error.message());
}

void write_text(const fs::path& path, const std::string& text) {
  write_file_whole(path, [&](std::ostream& out) { out << text; });
}

}  // namespace burin
