#pragma once
#include <cstdint>
#include <string>

namespace burin {

/// Values (texels times channels) of a stamp: 512 MB of floats.
constexpr std::uint64_t most_stamp_values = std::uint64_t{1} << 27;

/// Throws FileError when an image of so many values is none or too large for a stamp, or if it takes more
/// than 64 MB as floats and more than 4000 times the file: so that a small file cannot ask for much memory
/// and time. Compressed images of even texels, the worst of those that are meant, stay below that.
void expect_stamp_size(const std::string& path, std::uint64_t width, std::uint64_t height,
                       std::uint64_t channels, std::uint64_t file_bytes);

}  // namespace burin
