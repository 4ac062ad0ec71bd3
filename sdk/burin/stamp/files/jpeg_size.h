#pragma once
#include <cstdint>
#include <string_view>

namespace burin {

/// What the markers of a JPEG file tell: the size, before the library sets memory aside, which it does when
/// it opens a progressive one, and whether the file has its end, which the library makes up where it is cut
/// off.
struct JpegSize {
  std::uint32_t width = 0, height = 0, components = 0;  ///< all 0 where there is no frame
  bool has_end = false;
};
JpegSize jpeg_size(std::string_view bytes);

}  // namespace burin
