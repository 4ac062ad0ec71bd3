#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace burin {

/// The default limit of read_file: 256 MiB.
constexpr std::uintmax_t most_file_bytes = std::uintmax_t{1} << 28;

/// Reads a whole file, or a pipe to its end, as bytes. Throws FileError if it cannot be read, is a folder or
/// a device, or holds more than `most` bytes.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most = most_file_bytes);

/// Throws FileError if write_file_whole would, as far as can be known before writing, so that a bad path
/// fails before long work starts.
void check_output(const std::filesystem::path& path);

/// Calls `write` with a binary stream to a temporary file in the same folder, then renames that file to
/// `path`. So a file is either unchanged or complete. Symbolic links are followed; an existing file keeps its
/// mode. Pipes and character devices (/dev/null) are written to directly. Throws FileError if the file cannot
/// be written, and for block devices and sockets; exceptions of `write` pass through.
void write_file_whole(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Like write_file_whole, for libraries that write files by name: `write` gets the path of an empty temporary
/// file and fills that file.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& partial)>& write);

}  // namespace burin
