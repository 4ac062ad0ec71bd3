// Makes text from another process fit to be shown.
#include <burin/base/text/utf8.h>
#include <burin/host/isolate/message.h>

namespace burin::isolate {

std::string shown_text(std::string_view text, std::size_t most) {
  std::string shown;
  while (!text.empty()) {
    const std::string_view before = text;
    const auto code = pop_code_point(text);
    if (!code) text.remove_prefix(1);
    const std::string_view character = before.substr(0, before.size() - text.size());
    if (shown.size() + character.size() > most) break;
    if (code && !is_control(*code))
      shown += character;
    else
      shown += code ? ' ' : '?';
  }
  return shown;
}

}  // namespace burin::isolate
