// Forwards to a scene of triangles, or of points, in the room `picking`.
#include <burin/surface/picker.h>
#include <burin/surface/picking/pick_scene.h>

namespace burin {

Picker::Picker(const Surface& surface)
    : scene_(surface.is_point_set() ? make_point_scene(surface) : make_triangle_scene(surface)) {}
Picker::~Picker() = default;
Picker::Picker(Picker&&) noexcept = default;
Picker& Picker::operator=(Picker&&) noexcept = default;

std::optional<SurfacePoint> Picker::pick(const Ray& ray) const { return scene_->pick(ray); }

std::optional<SurfacePoint> Picker::closest(const Vec3f& position, float max_distance) const {
  return scene_->closest(position, max_distance);
}

std::optional<std::vector<Index>> Picker::near(const Vec3f& position, float max_distance,
                                               std::size_t most) const {
  return scene_->near(position, max_distance, most);
}

void Picker::update(std::span<const Index> moved_vertices) { scene_->update(moved_vertices); }

}  // namespace burin
