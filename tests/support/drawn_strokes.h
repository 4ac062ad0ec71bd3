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

/// The kinds of strokes that people draw, clean or not.
std::span<const std::string_view> drawn_kinds();

/// A pen's samples of a stroke of this kind in the plane, in units of the stroke's radius, within 3 of the
/// middle: of random shape and step, with the noise of a hand or without.
std::vector<Vec2d> drawn_stroke(std::string_view kind, std::mt19937& random);

/// A surface on which the geodesic distance to a curve is known.
class ExactShape {
 public:
  virtual ~ExactShape() = default;

  /// With edges about this long, reaching at least `reach` around the middle.
  virtual TriangleMesh mesh(double edge, double reach, std::uint32_t seed) const = 0;

  /// The place of a point of the plane, by which strokes are laid onto the shape; the middle is (0, 0).
  virtual Vec3d place(const Vec2d& in_plane) const = 0;

  /// Of x from the shortest way between a and b, all near the shape.
  virtual double distance(const Vec3d& x, const Vec3d& a, const Vec3d& b) const = 0;
};

std::unique_ptr<ExactShape> exact_plane();
std::unique_ptr<ExactShape> exact_cylinder();  ///< of radius 1
std::unique_ptr<ExactShape> exact_cone();      ///< whose sides stand at 30 degrees to its axis
std::unique_ptr<ExactShape> exact_sphere();    ///< of radius 1

}  // namespace burin::test
