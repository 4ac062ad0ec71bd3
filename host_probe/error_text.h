#pragma once
#include <burin/abi/base.h>

#include <cstdio>

namespace burin_probe {

/// Writes why a call failed, as much as there is room for.
inline void say(burin_text* text, const char* line) {
  if (text && text->data && text->capacity > 0) std::snprintf(text->data, text->capacity, "%s", line);
}

}  // namespace burin_probe
