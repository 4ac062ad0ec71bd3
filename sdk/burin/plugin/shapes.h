#pragma once
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>

/// Plane figures as signed distance functions: the distance of a point from the outline, negative inside.
/// Unions, intersections and outlines of figures are figures again; outside a corner of an intersection the
/// distance is a lower bound. Formulas after I. Quilez, "2D distance functions".
/// The functions may be called on any thread, also on several at once.
namespace burin::plugin {

/// A point in the plane of a figure: x along the stroke, y across it.
struct Point {
  float x, y;

  Point operator-(Point other) const { return {x - other.x, y - other.y}; }
};

/// The union of two figures.
inline float join(float a, float b) { return std::min(a, b); }
/// The intersection of two figures.
inline float cut(float a, float b) { return std::max(a, b); }

/// The band of this thickness along the inside of a figure's outline.
inline float outline(float distance, float thickness) {
  return std::abs(distance + thickness / 2) - thickness / 2;
}

/// The circle around the origin.
inline float circle(Point p, float radius) { return math::hypot(p.x, p.y) - radius; }

/// A rectangle, for a point whose distances beyond its sides along x and y are given, negative inside.
inline float rectangle(float x, float y) {
  return math::hypot(std::max(x, 0.0f), std::max(y, 0.0f)) + std::min(std::max(x, y), 0.0f);
}

/// The rectangle |x| <= half_x, |y| <= half_y.
inline float box(Point p, float half_x, float half_y) {
  return rectangle(std::abs(p.x) - half_x, std::abs(p.y) - half_y);
}

/// The rectangle 0 <= x <= length, |y| <= half_y.
inline float bar(Point p, float length, float half_y) {
  return rectangle(std::max(-p.x, p.x - length), std::abs(p.y) - half_y);
}

/// The points at most `radius` away from the segment |x| <= half_x of the x axis.
inline float capsule(Point p, float half_x, float radius) {
  return math::hypot(std::max(std::abs(p.x) - half_x, 0.0f), p.y) - radius;
}

/// The rhombus with its corners on the axes at +-half_x and +-half_y.
inline float diamond(Point p, float half_x, float half_y) {
  const float x = std::abs(p.x), y = std::abs(p.y);
  const float side = math::hypot(half_x, half_y);
  // The position of the nearest point on the side, as a share from the corner on the y axis.
  const float along = std::clamp((x * half_x - (y - half_y) * half_y) / (side * side), 0.0f, 1.0f);
  const float distance = math::hypot(x - along * half_x, y - (1 - along) * half_y);
  return x * half_y + y * half_x < half_x * half_y ? -distance : distance;
}

/// The triangle with its base at x = 0 from -half_y to half_y and its tip at x = length.
inline float triangle(Point p, float length, float half_y) {
  const float y = std::abs(p.y);
  const float along =
      std::clamp((p.x * length - (y - half_y) * half_y) / (length * length + half_y * half_y), 0.0f, 1.0f);
  const float to_side = math::hypot(p.x - along * length, y - (1 - along) * half_y);
  const float to_base = math::hypot(p.x, std::max(y - half_y, 0.0f));
  const bool inside = p.x > 0 && p.x * half_y + y * length < length * half_y;
  const float distance = std::min(to_side, to_base);
  return inside ? -distance : distance;
}

/// The regular hexagon with two sides at x = +-inner; outside its corners a lower bound.
inline float hexagon(Point p, float inner) {
  const float x = std::abs(p.x), y = std::abs(p.y);
  return std::max(x, 0.5f * x + 0.8660254f * y) - inner;
}

/// The share of a cell of this size that a figure covers, at this distance from the figure's outline.
inline float coverage(float distance, float footprint) {
  return std::clamp(0.5f - distance / std::max(footprint, 1e-30f), 0.0f, 1.0f);
}

}  // namespace burin::plugin
