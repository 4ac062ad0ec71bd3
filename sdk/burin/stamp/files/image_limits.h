#pragma once
#include <cstdint>
#include <string>

namespace burin {

/// The greatest number of values (texels times channels) of a stamp: 512 MB of floats.
constexpr std::uint64_t most_stamp_values = std::uint64_t{1} << 27;

/// Throws FileError if an image of this size is empty or too large for a stamp, or if it needs more than 64
/// MB as floats and more than 4000 times the size of its file, so that a small file cannot demand much memory
/// and time. Compressed images of one constant value, the worst legitimate case, stay below that factor.
void check_stamp_size(const std::string& path, std::uint64_t width, std::uint64_t height,
                      std::uint64_t channels, std::uint64_t file_bytes);

}  // namespace burin
