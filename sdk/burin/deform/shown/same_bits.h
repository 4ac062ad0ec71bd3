#pragma once
#include <burin/base/vector.h>

#include <array>
#include <bit>
#include <cstdint>

namespace burin {

/// Compares bits instead of values: if -0 and 0 counted as equal, results would depend on history.
inline bool same_bits(const Vec3f& a, const Vec3f& b) {
  using Bits = std::array<std::uint32_t, 3>;
  const auto bits = [](const Vec3f& v) { return std::bit_cast<Bits>(std::array{v.x(), v.y(), v.z()}); };
  return bits(a) == bits(b);
}

}  // namespace burin
