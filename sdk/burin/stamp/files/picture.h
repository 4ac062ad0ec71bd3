#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace burin {

/// A picture for display: sRGB bytes, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3
};

/// Writes a PNG, whole or not at all. Throws FileError, and ContractError for a picture without pixels or
/// with another number of bytes.
void write_png(const std::filesystem::path& path, const Picture& picture);

}  // namespace burin
