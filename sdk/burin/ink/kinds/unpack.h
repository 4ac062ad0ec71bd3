#pragma once
#include <filesystem>
#include <string>

namespace burin {

/// Most bytes that a packed file may unpack to: 64 MiB.
constexpr std::size_t most_unpacked_bytes = std::size_t{1} << 26;

/// The bytes of a file; unpacked if they are gzip or xz, and content.xml if they are a zip that has one.
/// Throws FileError for a damaged archive, and where more than most_unpacked_bytes come out.
std::string unpacked_pen_file(const std::filesystem::path& path);

}  // namespace burin
