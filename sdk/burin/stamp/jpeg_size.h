#pragma once
#include <cstdint>
#include <string_view>

namespace burin {

/// Width, height and components that the frame of a JPEG file tells, all 0 where there is none: known before
/// the library sets memory aside, which it does when it opens a progressive one.
struct JpegSize {
  std::uint32_t width = 0, height = 0, components = 0;
};
JpegSize jpeg_size(std::string_view bytes);

}  // namespace burin
