#pragma once
#include <filesystem>
#include <string>

namespace burin {

/// Throws FileError when no folder can be at `folder`: a file stands there. An empty path is no report.
void check_report_folder(const std::string& folder);

/// Creates the folder where needed. Throws FileError.
void make_report_folder(const std::string& folder);

/// Writes the file whole. Throws FileError.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace burin
