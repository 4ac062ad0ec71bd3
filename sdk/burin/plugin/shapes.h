#pragma once
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>

/// Plane figures by signed distance: how far a place is from their outline, negative inside. Unions, cuts
/// and outlines of them are figures again; beyond a corner of a cut the distance is a lower bound.
/// Formulas after I. Quilez, "2D distance functions".
namespace burin::plugin {

/// A place in the plane of a figure: x along the stroke, y across it.
struct Place {
  float x, y;

  Place operator-(Place other) const { return {x - other.x, y - other.y}; }
};

inline float join(float a, float b) { return std::min(a, b); }
inline float cut(float a, float b) { return std::max(a, b); }

/// A band of this thickness on the inside of the outline.
inline float outline(float distance, float thickness) {
  return std::abs(distance + thickness / 2) - thickness / 2;
}

inline float circle(Place p, float radius) { return math::hypot(p.x, p.y) - radius; }

/// A rectangle that the place lies beyond by so much along x and y, negative inside.
inline float rectangle(float x, float y) {
  return math::hypot(std::max(x, 0.0f), std::max(y, 0.0f)) + std::min(std::max(x, y), 0.0f);
}

/// The rectangle |x| <= half_x, |y| <= half_y.
inline float box(Place p, float half_x, float half_y) {
  return rectangle(std::abs(p.x) - half_x, std::abs(p.y) - half_y);
}

/// The rectangle 0 <= x <= length, |y| <= half_y.
inline float bar(Place p, float length, float half_y) {
  return rectangle(std::max(-p.x, p.x - length), std::abs(p.y) - half_y);
}

/// All that is at most `radius` away from the points |x| <= half_x of the x axis.
inline float capsule(Place p, float half_x, float radius) {
  return math::hypot(std::max(std::abs(p.x) - half_x, 0.0f), p.y) - radius;
}

/// The rhombus with its corners on the axes, at +-half_x and +-half_y.
inline float diamond(Place p, float half_x, float half_y) {
  const float x = std::abs(p.x), y = std::abs(p.y);
  const float side = math::hypot(half_x, half_y);
  // Along the side from the corner on the y axis, as a share of it.
  const float along = std::clamp((x * half_x - (y - half_y) * half_y) / (side * side), 0.0f, 1.0f);
  const float distance = math::hypot(x - along * half_x, y - (1 - along) * half_y);
  return x * half_y + y * half_x < half_x * half_y ? -distance : distance;
}

/// The triangle with its base at x = 0 from -half_y to half_y and its tip at x = length.
inline float triangle(Place p, float length, float half_y) {
  const float y = std::abs(p.y);
  const float along =
      std::clamp((p.x * length - (y - half_y) * half_y) / (length * length + half_y * half_y), 0.0f, 1.0f);
  const float to_side = math::hypot(p.x - along * length, y - (1 - along) * half_y);
  const float to_base = math::hypot(p.x, std::max(y - half_y, 0.0f));
  const bool inside = p.x > 0 && p.x * half_y + y * length < length * half_y;
  const float distance = std::min(to_side, to_base);
  return inside ? -distance : distance;
}

/// The regular hexagon with two sides at x = +-inner; beyond its corners a lower bound.
inline float hexagon(Place p, float inner) {
  const float x = std::abs(p.x), y = std::abs(p.y);
  return std::max(x, 0.5f * x + 0.8660254f * y) - inner;
}

/// Share of a cell of this size, at this distance from the outline of a figure, that the figure covers.
inline float coverage(float distance, float footprint) {
  return std::clamp(0.5f - distance / std::max(footprint, 1e-30f), 0.0f, 1.0f);
}

}  // namespace burin::plugin
