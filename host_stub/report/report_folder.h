#pragma once
#include <filesystem>
#include <string>

namespace burin {

/// Throws FileError if `folder` is an existing file. An empty path means no report.
void check_report_folder(const std::string& folder);

/// Creates the folder if needed. Throws FileError.
void make_report_folder(const std::string& folder);

/// Writes a file, wholly or not at all. Throws FileError.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace burin
