#pragma once
/// The axes of the channels of a vector displacement map. vector_axes() may be called on any thread.
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace burin::math {

/// Where a map stores x, y and z: x points to the right on the image (along texture coordinate u, the
/// tangent), y up on it (along v, the bitangent), z outward (along the normal).
struct VectorAxes {
  std::array<std::size_t, 3> channel = {0, 1, 2};  ///< channel that holds x, y, z
  std::array<float, 3> sign = {1, 1, 1};           ///< factor of x, y, z in that channel: 1 or -1
};

/// Parses the axes that the channels red, green and blue hold: each axis once, with "-" before one that is
/// stored negated, as in "x,y,z" or "x,z,-y". Or the name of a program: "blender" (its sculpt brushes:
/// x,y,z), "cycles" and "mudbox" (x,z,y). Returns nothing for any other text.
inline std::optional<VectorAxes> vector_axes(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> programs = {
      {{"blender", "x,y,z"}, {"cycles", "x,z,y"}, {"mudbox", "x,z,y"}}};
  for (const auto& [program, axes] : programs)
    if (text == program) text = axes;
  VectorAxes found;
  std::array<bool, 3> seen{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (channel > 0) {
      if (!text.starts_with(',')) return std::nullopt;
      text.remove_prefix(1);
    }
    const bool negated = text.starts_with('-');
    if (negated) text.remove_prefix(1);
    if (text.empty() || text.front() < 'x' || text.front() > 'z') return std::nullopt;
    const auto axis = static_cast<std::size_t>(text.front() - 'x');
    text.remove_prefix(1);
    if (std::exchange(seen[axis], true)) return std::nullopt;
    found.channel[axis] = channel;
    found.sign[axis] = negated ? -1.0f : 1.0f;
  }
  if (!text.empty()) return std::nullopt;
  return found;
}

}  // namespace burin::math
