#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A ray from a point, object units.
struct Ray {
  Vec3f origin;
  Vec3f direction;  ///< any length
};

class PickScene;

/// Finds the point where a ray meets a surface, and the point of a surface closest to a position. It refers
/// to the surface's positions and triangles, which must stay in place while the picker exists. pick(),
/// closest() and near() may be called from several threads at once, but not during update(). The first two
/// cost O(log n) for typical surfaces.
///
/// On a point set the surface is defined by moving least squares with the given normals (PointProjection). It
/// ends where points no longer surround a position.
class Picker {
 public:
  /// Builds the search tree, in O(n log n) or better.
  explicit Picker(const Surface& surface);
  ~Picker();
  Picker(Picker&&) noexcept;
  Picker& operator=(Picker&&) noexcept;

  /// The first hit along the ray, from either side; among equally near triangles the one with the lowest
  /// index. Watertight: no ray passes between triangles that share an edge. Returns nothing for a ray that
  /// misses.
  std::optional<SurfacePoint> pick(const Ray& ray) const;

  /// The closest point within max_distance, object units; among equally close triangles the one with the
  /// lowest index. On a point set it is the foot point near the closest point of the set, or beyond the
  /// border that point itself; this holds for positions nearer to the surface than its radius of curvature.
  std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const;

  /// Triangles, in any order, among them all that have a point within max_distance, object units; nothing if
  /// they are more than `most`. Throws ContractError for a point set.
  std::optional<std::vector<Index>> near(const Vec3f& position, float max_distance, std::size_t most) const;

  /// Updates the search tree after these vertices moved. Costs in proportion to their triangles. Throws
  /// ContractError for a point set.
  void update(std::span<const Index> moved_vertices);

 private:
  std::unique_ptr<PickScene> scene_;
};

}  // namespace burin
