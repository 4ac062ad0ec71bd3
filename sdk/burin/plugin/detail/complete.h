#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace burin::plugin {

/// A copy of a struct that the host filled. Members beyond the host's struct_size, which an older host does
/// not know, are zero or null, which is their default unless their comment in the ABI states another one.
template <class Struct>
Struct complete(const Struct& from_host) noexcept {
  static_assert(std::is_trivially_copyable_v<Struct>);
  Struct whole{};
  std::memcpy(static_cast<void*>(&whole), &from_host,
              std::min<std::size_t>(from_host.struct_size, sizeof whole));
  return whole;
}

}  // namespace burin::plugin
