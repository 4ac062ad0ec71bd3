#include "scenes.h"

#include <burin/base/error.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>

#include <algorithm>

#include "support/shared_data.h"

namespace burin::paper {
namespace {

namespace fs = std::filesystem;

Surface refined(const fs::path& cage_file, std::size_t triangles) {
  const PolygonMesh cage = read_mesh(cage_file);
  const SubdivisionScheme scheme = natural_scheme(cage);
  return make_surface(refine(cage, scheme, level_for_triangles(cage, scheme, triangles)));
}

std::optional<fs::path> shared_mesh(const std::string& file) { return test::shared_data("meshes/" + file); }

}  // namespace

Scenes::Scenes(bool quick) {
  const fs::path ewer = fs::path(BURIN_SAMPLES) / "meshes/ewer.obj";
  const std::size_t triangles = quick ? 20'000 : 700'000;
  scenes_.push_back(std::make_unique<Scene>("ewer", refined(ewer, triangles)));
  if (quick) {
    scenes_.front()->picture_width = 160;
    return;
  }
  for (const char* name : {"spot_control_mesh", "stanford-bunny", "nefertiti-lowres"}) {
    if (const auto file = shared_mesh(name + std::string(".obj")))
      scenes_.push_back(std::make_unique<Scene>(name, refined(*file, triangles)));
  }
}

const Scene* Scenes::find(const std::string& name) const {
  const auto found = std::ranges::find(scenes_, name, [](const auto& scene) { return scene->name; });
  return found == scenes_.end() ? nullptr : found->get();
}

Subject draw(const Scene& scene, const Drawing& drawing) {
  const double radius = drawing.radius * scene.surface.scale;
  Eigen::AlignedBox3f box;
  for (const Vec3f& position : scene.surface.positions) box.extend(position);
  const Vec3f anchor = box.min() + drawing.anchor.cwiseProduct(box.sizes());
  const Vec3f direction = drawing.direction.normalized();
  const Vec3f right = direction.cross(Vec3f::UnitY()).normalized(), up = right.cross(direction);
  CurveTracer tracer(scene.surface, scene.picker, radius);
  double time = 0;
  for (const Vec2d& place : drawing.pattern) {
    const Eigen::Vector2f offset = (radius * place).cast<float>();
    const Vec3f over = anchor + offset.x() * right + offset.y() * up;
    const auto at =
        scene.picker.pick({over - static_cast<float>(scene.surface.scale) * direction, direction});
    if (!at || (!tracer.curve().points.empty() && !tracer.connects(*at)))
      throw Error(drawing.name + ": the stroke leaves the " + scene.name);
    tracer.add(*at, time, {});
    time += 1. / 240;
  }
  return make_subject(scene, tracer.curve(), radius);
}

}  // namespace burin::paper
