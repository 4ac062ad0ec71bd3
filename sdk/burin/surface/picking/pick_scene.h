#pragma once
#include <burin/surface/picker.h>

#include <memory>
#include <optional>
#include <span>

namespace burin {

/// What stands behind a Picker, one a kind of surface. The contract is the picker's.
class PickScene {
 public:
  virtual ~PickScene() = default;
  virtual std::optional<SurfacePoint> pick(const Ray& ray) const = 0;
  virtual std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const = 0;
  virtual void update(std::span<const Index> moved_vertices) = 0;
};

std::unique_ptr<PickScene> make_triangle_scene(const Surface& surface);
std::unique_ptr<PickScene> make_point_scene(const Surface& surface);

}  // namespace burin
