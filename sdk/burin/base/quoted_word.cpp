#include <burin/base/quoted_word.h>
#include <burin/base/utf8.h>
#include <fmt/format.h>

namespace burin {
namespace {

constexpr std::size_t longest = 40;  ///< bytes

}  // namespace

std::string quoted_word(std::string_view word) {
  std::string text;
  const char* const begin = word.data();
  while (!word.empty()) {
    std::string_view rest = word;
    const auto code = take_code_point(rest);
    const std::size_t length = code ? word.size() - rest.size() : 1;
    if (static_cast<std::size_t>(word.data() - begin) + length > longest) return "'" + text + "...'";
    const std::string_view bytes = word.substr(0, length);
    if (code && !is_control(*code)) {
      text += bytes;
    } else {
      for (const char byte : bytes) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    }
    word.remove_prefix(length);
  }
  return "'" + text + "'";
}

}  // namespace burin
