// Checks a plugin's text code point by code point.
#include <burin/base/text/utf8.h>
#include <burin/host/plugin/descriptor_check.h>

namespace burin {

bool is_text(const char* text) {
  if (!text || *text == '\0') return false;
  for (std::string_view rest = text; !rest.empty();) {
    const auto code = pop_code_point(rest);
    if (!code || *code < 0x20 || *code == 0x7f) return false;
  }
  return true;
}

}  // namespace burin
