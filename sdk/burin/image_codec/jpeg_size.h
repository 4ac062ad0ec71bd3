#pragma once
#include <cstdint>
#include <string_view>

namespace burin {

/// Facts from the markers of a JPEG file: the size, which must be checked before the library opens a
/// progressive file and allocates memory for it, and whether the file has its end marker, which the library
/// supplies silently if the file is cut off.
struct JpegInfo {
  std::uint32_t width = 0, height = 0, components = 0;  ///< all 0 without a frame
  bool has_end = false;
};
/// Reads the markers of a JPEG file in O(bytes).
JpegInfo jpeg_size(std::string_view bytes);

}  // namespace burin
