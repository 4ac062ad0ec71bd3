// Makes one printable line of what a plugin wrote, whatever bytes that are.
#include <burin/deform/evaluate/error_text.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace burin {
namespace {

std::string status_text(burin_status status) {
  switch (status) {
    case BURIN_ERROR:
      return "failed without a reason";
    case BURIN_INVALID_ARGUMENT:
      return "invalid argument";
    case BURIN_UNSUPPORTED:
      return "not supported";
    case BURIN_NOT_FOUND:
      return "not found";
    case BURIN_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return fmt::format("failed with the unknown status {}", status);
  }
}

}  // namespace

ErrorText::ErrorText()
    : text_{sizeof(burin_text), static_cast<std::uint32_t>(buffer_.size()), buffer_.data()} {}

std::string ErrorText::line(burin_status status) const {
  // A plugin may have filled the buffer to its end without the zero.
  std::string text(buffer_.begin(), std::find(buffer_.begin(), buffer_.end(), '\0'));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text.empty() ? status_text(status) : text;
}

}  // namespace burin
