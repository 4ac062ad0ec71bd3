#pragma once
#include <burin/abi/ext/lettering.h>
#include <burin/abi/ext/stamps.h>
#include <burin/abi/ext/vdb_stamps.h>
#include <burin/services/stamp_extensions.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

namespace burin {

/// The service tables that StampExtensions::find() returns.
extern const burin_stamps stamps_service;
extern const burin_lettering lettering_service;
extern const burin_vdb_stamps vdb_stamps_service;

/// The extensions of a host that returned one of these tables.
inline StampExtensions& extensions_of(const burin_host* host) {
  return *static_cast<StampExtensions*>(services(host).extensions());
}

inline StampStore& stamps_of(const burin_host* host) { return extensions_of(host).stamps(); }

/// A copy of a struct that the caller filled. Members that the caller's version does not have are zero.
template <class Struct>
Struct known_members(const Struct& from_caller) {
  Struct whole{};
  std::memcpy(&whole, &from_caller, std::min<std::size_t>(from_caller.struct_size, sizeof whole));
  return whole;
}

/// Copies those members to *to that the caller's version has. `to` may be null.
template <class Struct>
void fill_known_members(Struct from, Struct* to) {
  if (!to) return;
  from.struct_size = to->struct_size;
  std::memcpy(to, &from, std::min<std::size_t>(to->struct_size, sizeof from));
}

/// Copies a line into the caller's buffer and truncates it if it is too long. `text` may be null.
inline void copy_text(std::string_view line, burin_text* text) {
  if (!text || text->capacity == 0) return;
  const std::size_t size = std::min<std::size_t>(line.size(), text->capacity - 1);
  std::memcpy(text->data, line.data(), size);
  text->data[size] = '\0';
}

/// Calls `work`, and turns an exception into a status and a text.
template <class Work>
burin_status status_of(burin_text* error, const Work& work) {
  try {
    work();
    return BURIN_OK;
  } catch (const std::bad_alloc&) {
    copy_text("out of memory", error);
    return BURIN_OUT_OF_MEMORY;
  } catch (const std::exception& failure) {
    copy_text(failure.what(), error);
    return BURIN_ERROR;
  }
}

}  // namespace burin
