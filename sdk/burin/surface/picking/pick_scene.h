#pragma once
#include <burin/surface/picker.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The implementation of a Picker, one per kind of surface. The contract is that of Picker.
class PickScene {
 public:
  virtual ~PickScene() = default;
  virtual std::optional<SurfacePoint> pick(const Ray& ray) const = 0;
  virtual std::optional<SurfacePoint> closest(const Vec3f& position, float max_distance) const = 0;
  virtual std::optional<std::vector<Index>> near(const Vec3f& position, float max_distance,
                                                 std::size_t most) const = 0;
  virtual void update(std::span<const Index> moved_vertices) = 0;
};

std::unique_ptr<PickScene> make_triangle_scene(const Surface& surface);
std::unique_ptr<PickScene> make_point_scene(const Surface& surface);

}  // namespace burin
