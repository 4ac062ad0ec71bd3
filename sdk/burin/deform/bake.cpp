#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/deform/bake.h>
#include <burin/deform/pad_islands.h>
#include <burin/deform/uv_raster.h>
#include <burin/surface/adjacency.h>
#include <burin/surface/normals.h>
#include <burin/surface/triangle_shape.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr std::size_t elements_a_block = 8192;
constexpr double rounding = 1e-5;     ///< of texture coordinates in files and by refinement
constexpr double tile_margin = 0.05;  ///< real meshes have islands that reach a little beyond the image

/// Calls body(i) for i in [0, count), on all threads.
template <class Body>
void for_each(std::size_t count, const Body& body) {
  parallel_blocks(count, elements_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Whether texture coordinates lie farther than this outside 0..1.
bool outside_by(double margin, const Vec2d& uv) {
  return !(uv.minCoeff() >= -margin && uv.maxCoeff() <= 1 + margin);
}

/// Those have no place in incident_triangles(), and no area to bake.
void drop_triangles_that_name_a_vertex_twice(TriangleMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (names_a_vertex_twice(mesh.triangles[i])) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    mesh.triangle_uv[kept++] = mesh.triangle_uv[i];
  }
  mesh.triangles.resize(kept);
  mesh.triangle_uv.resize(kept);
}

/// Twice the area of a triangle of texture coordinates, below 0 when they show it mirrored.
double doubled_area(const TriangleUv& uv) {
  const Vec2d along = (uv[1] - uv[0]).cast<double>(), across = (uv[2] - uv[0]).cast<double>();
  return along.x() * across.y() - along.y() * across.x();
}

/// dP/du of a triangle times twice its area in texture coordinates.
Vec3d weighted_tangent(const TriangleMesh& mesh, Index index) {
  const Triangle& triangle = mesh.triangles[index];
  const TriangleUv& uv = mesh.triangle_uv[index];
  const auto side = [&](std::size_t corner) -> Vec3d {
    return mesh.positions[triangle[corner]].cast<double>() - mesh.positions[triangle[0]].cast<double>();
  };
  const auto rise = [&](std::size_t corner) { return static_cast<double>(uv[corner].y() - uv[0].y()); };
  const Vec3d tangent = side(1) * rise(2) - side(2) * rise(1);
  return doubled_area(uv) < 0 ? Vec3d(-tangent) : tangent;
}

/// What the displacement is measured against, at the vertices of the base.
class BaseFrames {
 public:
  BaseFrames(const TriangleMesh& base, bool tangents)
      : base_(base),
        incident_(incident_triangles(base.positions.size(), base.triangles)),
        normals_(base.positions.size()) {
    for_each(normals_.size(), [&](std::size_t vertex) {
      normals_[vertex] = vertex_normal(base.triangles, incident_, base.positions, static_cast<Index>(vertex));
    });
    tangents_.resize(tangents ? base.triangles.size() : 0);
    for_each(tangents_.size(), [&](std::size_t triangle) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        tangents_[triangle][corner] = tangent(static_cast<Index>(triangle), corner);
    });
  }

  Vec3d normal(Index triangle, const Vec3d& weights) const {
    Vec3d sum = Vec3d::Zero();
    for (std::size_t corner = 0; corner < 3; ++corner)
      sum += weights[static_cast<int>(corner)] * normals_[base_.triangles[triangle][corner]].cast<double>();
    return sum.squaredNorm() > 1e-12 ? sum.normalized()
                                     : normals_[base_.triangles[triangle][0]].cast<double>();
  }

  /// Rows t, n x t, n.
  Eigen::Matrix3d frame(Index triangle, const Vec3d& weights) const {
    const Vec3d n = normal(triangle, weights);
    Vec3d sum = Vec3d::Zero();
    for (std::size_t corner = 0; corner < 3; ++corner)
      sum += weights[static_cast<int>(corner)] * tangents_[triangle][corner].cast<double>();
    const Vec3d across = sum - sum.dot(n) * n;
    const Vec3d t = across.squaredNorm() > 1e-12 ? across.normalized() : n.unitOrthogonal();
    Eigen::Matrix3d frame;
    frame << t.transpose(), n.cross(t).transpose(), n.transpose();
    return frame;
  }

 private:
  /// Unit, or 0 where no triangle has an area. An island ends where texture coordinates jump or are mirrored.
  Vec3f tangent(Index triangle, std::size_t corner) const {
    const Index vertex = base_.triangles[triangle][corner];
    const TriangleUv& uv = base_.triangle_uv[triangle];
    Vec3d sum = Vec3d::Zero();
    for (const Index other : incident_[vertex]) {
      const TriangleUv& other_uv = base_.triangle_uv[other];
      const bool mirrored = (doubled_area(uv) < 0) != (doubled_area(other_uv) < 0);
      if (!mirrored && other_uv[corner_of(base_.triangles[other], vertex)] == uv[corner])
        sum += weighted_tangent(base_, other);
    }
    return sum.stableNormalized().cast<float>();
  }

  const TriangleMesh& base_;
  Csr incident_;
  std::vector<Vec3f> normals_;                  ///< [vertex]
  std::vector<std::array<Vec3f, 3>> tangents_;  ///< [triangle][corner], where asked for
};

Vec3d displacement(const TriangleMesh& base, std::span<const Vec3f> displaced, Index triangle,
                   const Vec3d& weights) {
  Vec3d sum = Vec3d::Zero();
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Index vertex = base.triangles[triangle][corner];
    sum += weights[static_cast<int>(corner)] *
           (displaced[vertex].cast<double>() - base.positions[vertex].cast<double>());
  }
  return sum;
}

void fill(FloatImage& image, const UvRaster& raster, const TriangleMesh& base,
          std::span<const Vec3f> displaced) {
  const bool vectors = image.channels.size() == 3;
  const BaseFrames frames(base, vectors);
  for_each(raster.triangle.size(), [&](std::size_t texel) {
    const Index triangle = raster.triangle[texel];
    if (triangle == no_index) return;
    const Vec3d weights = barycentric(base.triangle_uv[triangle], raster.centre(texel));
    const Vec3d offset = displacement(base, displaced, triangle, weights);
    if (vectors) {
      Eigen::Map<Vec3f>(image.texels.data() + 3 * texel) =
          (frames.frame(triangle, weights) * offset).cast<float>();
    } else {
      image.texels[texel] = static_cast<float>(frames.normal(triangle, weights).dot(offset));
    }
  });
}

}  // namespace

void check_bakeable(const PolygonMesh& mesh) {
  if (mesh.corner_uv.empty()) throw Error("not every face has texture coordinates, which a map needs");
  std::size_t corner = 0;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    Vec2d mean = Vec2d::Zero();
    for (const std::size_t end = corner + mesh.face_sizes[face]; corner < end; ++corner)
      mean += mesh.corner_uv[corner].cast<double>() / mesh.face_sizes[face];
    if (outside_by(tile_margin, mean))
      throw Error(fmt::format(
          "face {} lies around ({:.6g}, {:.6g}) in texture coordinates; a map holds those from 0 to 1, "
          "not further tiles (UDIM) or repetitions",
          face + 1, mean.x(), mean.y()));
  }
}

BakedMap bake_displacement(TriangleMesh base, std::span<const Vec3f> displaced,
                           const BakeSettings& settings) {
  if (base.triangle_uv.size() != base.triangles.size() || displaced.size() != base.positions.size() ||
      settings.size < 1)
    throw ContractError("bake_displacement: no texture coordinates, no texels or another number of vertices");
  drop_triangles_that_name_a_vertex_twice(base);
  const UvRaster raster = rasterise(base.triangle_uv, settings.size);
  BakedMap map;
  map.overlaps = raster.overlaps;
  map.cut = static_cast<std::size_t>(std::ranges::count_if(base.triangle_uv, [](const TriangleUv& triangle) {
    return std::ranges::any_of(triangle,
                               [](const Vec2f& uv) { return outside_by(rounding, uv.cast<double>()); });
  }));
  FloatImage& image = map.image;
  image.width = image.height = settings.size;
  image.channels = settings.vectors ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  image.texels.resize(raster.triangle.size() * image.channels.size());
  fill(image, raster, base, displaced);
  std::vector<std::uint8_t> known(raster.triangle.size());
  for_each(known.size(),
           [&](std::size_t texel) { known[texel] = raster.triangle[texel] != no_index ? 1 : 0; });
  pad_islands(image, known, settings.padding);
  return map;
}

}  // namespace burin
