#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <memory>
#include <optional>
#include <span>

namespace burin {

struct Ray {
  Vec3f origin;
  Vec3f direction;  ///< any length
};

class PickScene;

/// Answers where a ray meets a surface and which point of it is closest. Looks at the surface's own
/// positions and triangles, which must stay in place while the picker lives.
/// pick and closest: any thread, concurrent, but not during update.
///
/// On a point set the surface is the smooth one that moving least squares with the given normals make of the
/// points. It ends where no points surround a place any more.
class Picker {
 public:
  explicit Picker(const Surface& surface);
  ~Picker();
  Picker(Picker&&) noexcept;
  Picker& operator=(Picker&&) noexcept;

  /// First hit along the ray, from either side; of equally near triangles the lowest. Watertight: no ray
  /// passes between triangles that share an edge.
  std::optional<SurfacePoint> pick(const Ray& ray) const;

  /// The closest point within max_distance; of equally close triangles the lowest. On a point set the foot
  /// near the closest point of the set, or beyond the border that point itself: for positions nearer to the
  /// surface than it bends.
  std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const;

  /// Follows the surface after these vertices moved. Costs in proportion to their triangles. Throws
  /// ContractError for a point set.
  void update(std::span<const Index> moved_vertices);

 private:
  std::unique_ptr<PickScene> scene_;
};

}  // namespace burin
