// Measures the parts beside a surface. Volumes are sums of the signed volumes of
// the tetrahedra from the origin to the triangles.
#include "replay/solid_parts.h"

#include <burin/surface/append_mesh.h>
#include <burin/volume/solid.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "pictures/result_picture.h"

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

SolidParts::SolidParts(const Session& session) : meshes_(part_meshes(session)) {
  for (const StrokeSolid& solid : session.parts()) voxels_.push_back(solid.voxel());
}

void SolidParts::append_to(TriangleMesh& mesh, VertexPaint& paint) const {
  for (const TriangleMesh& part : meshes_) {
    append(part, mesh);
    append_bare(paint.colours, part.positions.size(), {0, 0, 0, 0});
    append_bare(paint.masks, part.positions.size(), 1.0F);
  }
}

Json SolidParts::json() const {
  Json parts = Json::array();
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    Json part = Json::object();
    if (i < voxels_.size()) part["voxel"] = voxels_[i];
    part["vertices"] = meshes_[i].positions.size();
    part["triangles"] = meshes_[i].triangles.size();
    part["volume"] = volume_of(meshes_[i]);
    part["area"] = area_of(meshes_[i]);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::string SolidParts::text() const {
  std::string text;
  for (std::size_t i = 0; i < meshes_.size(); ++i)
    text += fmt::format(
        "part            {} triangles{}, volume {:.4g}, area {:.4g}\n", meshes_[i].triangles.size(),
        i < voxels_.size() ? fmt::format(" in voxels of {:.3g}", voxels_[i]) : " bent along the stroke",
        volume_of(meshes_[i]), area_of(meshes_[i]));
  return text;
}

}  // namespace burin
