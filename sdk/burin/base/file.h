#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace burin {

/// What read_file reads at most unless told otherwise: 256 MiB.
constexpr std::uintmax_t most_file_bytes = std::uintmax_t{1} << 28;

/// The whole file as bytes, or what comes through a pipe. Throws FileError when it cannot be read, is a
/// device or holds more than `most` bytes, which a pipe is found out about after as many.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most = most_file_bytes);

/// Throws FileError where write_file_whole would, as far as can be known: said before long work, not after
/// it.
void check_output(const std::filesystem::path& path);

/// Calls `write` with a binary stream and moves the result to `path` only when all of it is written, so
/// that a file is either as it was or complete. Until then it lies beside it under a name that no other file
/// has. Links lead to the file that is written; a file that was there before keeps its mode. Pipes and
/// character devices (/dev/null) are written to as they are. Throws FileError when it cannot be written, and
/// for block devices and sockets; what `write` throws passes through.
void write_file_whole(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// The same for what writes files by their name: `write` gets the name to write to, of an empty file that is
/// there.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& partial)>& write);

}  // namespace burin
