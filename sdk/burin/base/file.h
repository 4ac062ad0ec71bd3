#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace burin {

/// The whole file as bytes. Throws FileError when it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Calls `write` with a binary stream and moves the result to `path` only when all of it is written, so
/// that a file is either as it was or complete. Throws FileError when it cannot be written; what `write`
/// throws passes through.
void write_file_whole(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// The same for what writes files by their name: `write` gets the name to write to.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& partial)>& write);

}  // namespace burin
