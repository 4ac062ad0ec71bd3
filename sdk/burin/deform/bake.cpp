// Bakes displacement maps: rasterises the base's triangles in texture space (uv_raster.h), interpolates the
// displacement at each texel's centre, and pads the islands. Costs O(texels + triangles), on all threads.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/deform/bake.h>
#include <burin/deform/bake/base_frames.h>
#include <burin/deform/bake/pad_islands.h>
#include <burin/deform/bake/uv_raster.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::size_t texels_per_block = 8192;
constexpr double rounding = 1e-5;     ///< rounding of texture coordinates by files and by refinement
constexpr double tile_margin = 0.05;  ///< how far islands of real meshes may reach beyond the image

/// Whether texture coordinates lie farther than this outside 0..1.
bool outside_by(double margin, const Vec2d& uv) {
  return !(uv.minCoeff() >= -margin && uv.maxCoeff() <= 1 + margin);
}

/// Removes triangles that incident_triangles() does not accept; they have no area to bake.
void drop_triangles_that_name_a_vertex_twice(TriangleMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (has_repeated_vertex(mesh.triangles[i])) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    mesh.triangle_uv[kept++] = mesh.triangle_uv[i];
  }
  mesh.triangles.resize(kept);
  mesh.triangle_uv.resize(kept);
}

std::size_t count_cut(const TriangleMesh& mesh) {
  const auto outside = [](const Vec2f& uv) { return outside_by(rounding, uv.cast<double>()); };
  const auto cut = [&](const TriangleUv& triangle) { return std::ranges::any_of(triangle, outside); };
  return static_cast<std::size_t>(std::ranges::count_if(mesh.triangle_uv, cut));
}

/// Whether a triangle has an area in texture space that exceeds the rounding of its coordinates.
bool has_area(const TriangleUv& uv) {
  const Vec2d edge = (uv[1] - uv[0]).cast<double>(), other = (uv[2] - uv[0]).cast<double>();
  const double squares = edge.squaredNorm() * other.squaredNorm(), along = edge.dot(other);
  return squares - along * along > rounding * rounding * squares;
}

std::size_t count_without_area(const TriangleMesh& base, std::span<const Vec3f> displaced) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < base.triangles.size(); ++i) {
    const bool moved = std::ranges::any_of(
        base.triangles[i], [&](Index vertex) { return displaced[vertex] != base.positions[vertex]; });
    count +=
        moved && !has_area(base.triangle_uv[i]) && burin::has_area(base.positions, base.triangles[i]) ? 1 : 0;
  }
  return count;
}

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

/// Converts a vector to red, green and blue.
Vec3f channels_of(const Vec3d& vector, const math::VectorAxes& axes) {
  Vec3f channels;
  for (std::size_t axis = 0; axis < 3; ++axis)
    channels[static_cast<int>(axes.channel[axis])] =
        axes.sign[axis] * static_cast<float>(vector[static_cast<int>(axis)]);
  return channels;
}

/// Sets the texels that triangles cover; returns 1 for each such texel, else 0.
std::vector<std::uint8_t> fill(FloatImage& image, const UvRaster& raster, const TriangleMesh& base,
                               std::span<const Vec3f> displaced, const BakeSettings& settings) {
  const BaseFrames frames(base, settings.vectors && !settings.object_space);
  std::vector<std::uint8_t> filled(raster.triangle.size());
  const auto fill_texel = [&](std::size_t texel, Index triangle) {
    const Vec3d weights = barycentric(base.triangle_uv[triangle], raster.centre(texel));
    const Vec3d offset = displacement(base, displaced, triangle, weights);
    if (settings.vectors) {
      const Vec3d vector = settings.object_space ? offset : frames.frame(triangle, weights) * offset;
      Eigen::Map<Vec3f>(image.texels.data() + 3 * texel) = channels_of(vector, settings.axes);
    } else {
      image.texels[texel] = static_cast<float>(frames.normal(triangle, weights).dot(offset));
    }
    filled[texel] = 1;
  };
  parallel_blocks(filled.size(), texels_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t texel = begin; texel < end; ++texel)
      if (const Index triangle = raster.triangle[texel]; triangle != no_index) fill_texel(texel, triangle);
  });
  return filled;
}

}  // namespace

void check_bakeable(const PolygonMesh& mesh) {
  if (mesh.corner_uv.empty()) throw Error("not every face has texture coordinates, which a map needs");
  std::size_t corner = 0;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    Vec2d mean = Vec2d::Zero();
    for (const std::size_t end = corner + mesh.face_sizes[face]; corner < end; ++corner)
      mean += mesh.corner_uv[corner].cast<double>() / mesh.face_sizes[face];
    if (!mean.allFinite())
      throw Error(fmt::format("face {} has texture coordinates that are no numbers", face + 1));
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
  map.cut = count_cut(base);
  map.without_area = count_without_area(base, displaced);
  FloatImage& image = map.image;
  image.width = image.height = settings.size;
  image.channels = settings.vectors ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  image.texels.resize(raster.triangle.size() * image.channels.size());
  std::vector<std::uint8_t> filled = fill(image, raster, base, displaced, settings);
  pad_islands(image, filled, settings.padding);
  for (float& texel : image.texels) texel += settings.middle;
  return map;
}

}  // namespace burin
