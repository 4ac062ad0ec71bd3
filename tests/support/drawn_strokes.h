#pragma once
#include <burin/base/vector.h>
#include <burin/surface/triangle_mesh.h>

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <random>
#include <span>
#include <string_view>
#include <vector>

namespace burin::test {

/// The kinds of strokes that drawn_stroke() makes, with or without noise.
std::span<const std::string_view> drawn_kinds();

/// The pen samples of a stroke of this kind in the plane, in units of the stroke's radius, within 3 of the
/// middle. Shape and step are random; some kinds have the noise of a hand.
std::vector<Vec2d> drawn_stroke(std::string_view kind, std::mt19937& random);

/// A surface on which the geodesic distance to a curve is known.
class ExactShape {
 public:
  virtual ~ExactShape() = default;

  /// A mesh with edges of about this length that reaches at least `reach` around the middle.
  virtual TriangleMesh mesh(double edge, double reach, std::uint32_t seed) const = 0;

  /// Maps a point of the plane to the shape, by which strokes are placed on it; the middle is (0, 0).
  virtual Vec3d place(const Vec2d& in_plane) const = 0;

  /// The distance of x from the shortest path between a and b; all are near the shape.
  virtual double distance(const Vec3d& x, const Vec3d& a, const Vec3d& b) const = 0;
};

std::unique_ptr<ExactShape> exact_plane();
std::unique_ptr<ExactShape> exact_cylinder();  ///< radius 1
std::unique_ptr<ExactShape> exact_cone();      ///< sides at 30 degrees to the axis
std::unique_ptr<ExactShape> exact_sphere();    ///< radius 1

}  // namespace burin::test
