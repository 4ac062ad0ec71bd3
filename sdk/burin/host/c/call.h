#pragma once
#include <burin/abi/base.h>
#include <burin/plugin/detail/complete.h>
#include <burin/plugin/detail/error.h>

#include <algorithm>
#include <cstring>
#include <string>

/// What the functions have in common that applications call from C.
namespace burin::c {

/// A caller's fault, for which C has a status of its own.
[[noreturn]] inline void reject(const std::string& what) {
  throw plugin::Error(what, BURIN_INVALID_ARGUMENT);
}

/// Rejects a null pointer.
inline void require(const void* pointer, const char* name) {
  if (!pointer) reject(std::string(name) + " is missing");
}

/// A copy of a struct that the caller filled. Members that the caller's version does not have are zero.
/// `has_first`: whether it holds all members of the first version.
template <class Struct>
Struct known_members(const Struct* given, bool has_first, const char* name) {
  if (!has_first) reject(std::string(name) + " is missing or too small");
  return plugin::complete(*given);
}

/// Gives a struct to the caller, who set its struct_size: as much as fits.
template <class Struct>
void give(const Struct& result, Struct* given, bool has_first, const char* name) {
  if (!has_first) reject(std::string(name) + " is missing or too small");
  Struct whole = result;
  whole.struct_size = given->struct_size;
  std::memcpy(given, &whole, std::min<std::size_t>(given->struct_size, sizeof whole));
}

}  // namespace burin::c
