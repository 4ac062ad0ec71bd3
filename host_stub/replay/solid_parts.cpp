#include "replay/solid_parts.h"

#include <burin/level_set/solid_mesh.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace burin {
namespace {

Vec3d corner(const TriangleMesh& mesh, const Triangle& triangle, std::size_t i) {
  return mesh.positions[triangle[i]].cast<double>();
}

double volume_of(const TriangleMesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles)
    volume += corner(mesh, t, 0).dot(corner(mesh, t, 1).cross(corner(mesh, t, 2))) / 6;
  return volume;
}

double area_of(const TriangleMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = corner(mesh, t, 0);
    area += (corner(mesh, t, 1) - a).cross(corner(mesh, t, 2) - a).norm() / 2;
  }
  return area;
}

template <class Value>
void append_bare(std::vector<Value>& values, std::size_t count, const Value& bare) {
  if (!values.empty()) values.resize(values.size() + count, bare);
}

}  // namespace

SolidParts::SolidParts(std::span<const StrokeSolid> solids) {
  for (const StrokeSolid& solid : solids) {
    voxels_.push_back(solid.voxel());
    meshes_.push_back(mesh_of(solid));
  }
}

void SolidParts::append_to(TriangleMesh& mesh, VertexPaint& paint) const {
  for (const TriangleMesh& part : meshes_) {
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const Triangle& t : part.triangles)
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    append_bare(mesh.triangle_uv, part.triangles.size(), {Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()});
    append_bare(paint.colours, part.positions.size(), {0, 0, 0, 0});
    append_bare(paint.masks, part.positions.size(), 1.0F);
  }
}

Json SolidParts::json() const {
  Json parts = Json::array();
  for (std::size_t i = 0; i < meshes_.size(); ++i)
    parts.push_back({{"voxel", voxels_[i]},
                     {"vertices", meshes_[i].positions.size()},
                     {"triangles", meshes_[i].triangles.size()},
                     {"volume", volume_of(meshes_[i])},
                     {"area", area_of(meshes_[i])}});
  return parts;
}

std::string SolidParts::text() const {
  std::string text;
  for (std::size_t i = 0; i < meshes_.size(); ++i)
    text += fmt::format("part            {} triangles in voxels of {:.3g}, volume {:.4g}, area {:.4g}\n",
                        meshes_[i].triangles.size(), voxels_[i], volume_of(meshes_[i]), area_of(meshes_[i]));
  return text;
}

}  // namespace burin
