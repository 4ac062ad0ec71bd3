// Reads meshes from arrays of numbers of several types and strides, in O(corners). Numbers are copied by
// bytes, since strides may leave them unaligned.
#include <burin/host/c/call.h>
#include <burin/host/c/mesh_arrays.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace burin::c {
namespace {

constexpr std::uint64_t most_vertices = no_index;

/// An array of the caller's, of numbers of which several belong together.
struct Strided {
  const char* data;
  std::uint64_t stride;  ///< bytes

  template <class Number>
  Number at(std::uint64_t element, std::size_t place) const {
    Number number;
    std::memcpy(&number, data + element * stride + place * sizeof number, sizeof number);
    return number;
  }
};

template <class Number>
std::vector<Vec3f> read_positions(const burin_mesh& given) {
  const Strided array{static_cast<const char*>(given.positions),
                      given.position_stride ? given.position_stride : 3 * sizeof(Number)};
  std::vector<Vec3f> positions(given.vertex_count);
  for (std::uint64_t vertex = 0; vertex < given.vertex_count; ++vertex) {
    for (std::size_t k = 0; k < 3; ++k)
      positions[vertex][static_cast<Eigen::Index>(k)] = static_cast<float>(array.at<Number>(vertex, k));
    if (!positions[vertex].allFinite())
      reject(fmt::format("vertex {} has a coordinate that is not finite", vertex));
  }
  return positions;
}

/// Writes the corners of faces that all have `size` of them to `out`.
template <class Number>
void read_corners(const burin_mesh& given, std::size_t size, std::uint64_t faces, Index* out) {
  const std::uint64_t stride = given.face_stride ? given.face_stride : size * sizeof(Number);
  const Strided array{static_cast<const char*>(given.corners), stride};
  for (std::uint64_t face = 0; face < faces; ++face) {
    for (std::size_t k = 0; k < size; ++k) {
      const auto corner = array.at<Number>(face, k);
      if (corner >= given.vertex_count)
        reject(fmt::format("corner {} of the corners is vertex {}, but there are {}", face * size + k, corner,
                           given.vertex_count));
      *out++ = static_cast<Index>(corner);
    }
  }
}

template <class Number>
std::vector<Index> read_face_sizes(const burin_mesh& given, std::uint64_t& corner_count) {
  const Strided array{static_cast<const char*>(given.face_sizes), sizeof(Number)};
  std::vector<Index> sizes;
  sizes.reserve(given.face_count);
  corner_count = 0;
  for (std::uint64_t face = 0; face < given.face_count; ++face) {
    const auto size = array.at<Number>(face, 0);
    if (size < 3 || size > most_vertices) reject(fmt::format("face {} has {} corners", face, size));
    sizes.push_back(static_cast<Index>(size));
    corner_count += size;
  }
  return sizes;
}

template <class Number>
TriangleMesh with_triangles(const burin_mesh& given, std::vector<Vec3f> positions) {
  TriangleMesh mesh{std::move(positions), std::vector<Triangle>(given.face_count)};
  if (given.face_count > 0) read_corners<Number>(given, 3, given.face_count, mesh.triangles.front().data());
  return mesh;
}

template <class Number>
PolygonMesh with_faces(const burin_mesh& given, std::vector<Vec3f> positions) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  std::uint64_t corners = given.face_count * given.face_size;
  if (given.face_size != 0)
    mesh.face_sizes.assign(given.face_count, given.face_size);
  else
    mesh.face_sizes = read_face_sizes<Number>(given, corners);
  mesh.face_vertices.resize(corners);
  if (given.face_size != 0)
    read_corners<Number>(given, given.face_size, given.face_count, mesh.face_vertices.data());
  else
    read_corners<Number>(given, 1, corners, mesh.face_vertices.data());
  return mesh;
}

void check(const burin_mesh& given) {
  require(given.positions, "positions");
  require(given.corners, "corners");
  if (given.position_type != BURIN_FLOAT32 && given.position_type != BURIN_FLOAT64)
    reject("position_type is neither BURIN_FLOAT32 nor BURIN_FLOAT64");
  if (given.corner_type != BURIN_UINT32 && given.corner_type != BURIN_UINT64)
    reject("corner_type is neither BURIN_UINT32 nor BURIN_UINT64");
  if (given.vertex_count > most_vertices || given.face_count > most_vertices)
    reject("there are more than 2^32 - 1 vertices or faces");
  if ((given.face_size == 0) != (given.face_sizes != nullptr))
    reject("faces want either face_size or face_sizes");
  if (given.face_size == 1 || given.face_size == 2) reject("faces have fewer than 3 corners");
  if (given.face_sizes && given.face_stride != 0) reject("faces of several sizes have no stride");
  if (given.order < BURIN_ORDER_UNKNOWN || given.order > BURIN_ORDER_SURFACE)
    reject("there is no such order");
}

std::vector<Vec3f> checked_positions(const burin_mesh& given) {
  check(given);
  return given.position_type == BURIN_FLOAT32 ? read_positions<float>(given) : read_positions<double>(given);
}

}  // namespace

TriangleMesh read_arrays(const burin_mesh& given) {
  if (given.face_size != 3) return triangulate(read_polygons(given));
  std::vector<Vec3f> positions = checked_positions(given);
  return given.corner_type == BURIN_UINT32 ? with_triangles<std::uint32_t>(given, std::move(positions))
                                           : with_triangles<std::uint64_t>(given, std::move(positions));
}

std::vector<Index> read_triangle_faces(const burin_mesh& given) {
  std::vector<Index> sizes(given.face_sizes ? 0 : given.face_count, given.face_size);
  std::uint64_t corners = 0;
  if (given.face_sizes)
    sizes = given.corner_type == BURIN_UINT32 ? read_face_sizes<std::uint32_t>(given, corners)
                                              : read_face_sizes<std::uint64_t>(given, corners);
  std::vector<Index> faces;
  for (std::size_t face = 0; face < sizes.size(); ++face)
    faces.insert(faces.end(), sizes[face] - 2, static_cast<Index>(face));
  return faces;
}

PolygonMesh read_polygons(const burin_mesh& given) {
  std::vector<Vec3f> positions = checked_positions(given);
  return given.corner_type == BURIN_UINT32 ? with_faces<std::uint32_t>(given, std::move(positions))
                                           : with_faces<std::uint64_t>(given, std::move(positions));
}

}  // namespace burin::c
