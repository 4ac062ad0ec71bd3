// Writes binary little-endian PLY files, 65536 elements at a time. Texture coordinates are vertex properties
// if triangles agree on them at every vertex, else lists of the faces.
#include <burin/base/file.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/over_clay.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>

namespace burin {
namespace {

constexpr std::size_t elements_per_chunk = 65536;

template <class Bits>
void put_little_endian(std::string& bytes, Bits value) {
  for (int shift = 0; shift < 8 * static_cast<int>(sizeof value); shift += 8)
    bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

void put_number(std::string& bytes, float value) {
  put_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
}

void put_number(std::string& bytes, double value) {
  put_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}

void put_number(std::string& bytes, const Vec2f& uv) {
  for (const float coordinate : uv) put_number(bytes, coordinate);
}

void put_bytes(std::string& bytes, const PaintBytes& colour, std::size_t channels) {
  for (std::size_t i = 0; i < channels; ++i) bytes.push_back(static_cast<char>(colour[i]));
}

/// Texture coordinates by vertex, zero at vertices without a triangle; empty if triangles disagree at a
/// vertex.
std::vector<Vec2f> vertex_uv(const TriangleMesh& mesh) {
  if (mesh.triangle_uv.empty()) return {};
  std::vector<Vec2f> uv(mesh.positions.size(), Vec2f::Zero());
  std::vector<bool> known(uv.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index vertex = mesh.triangles[i][corner];
      if (known[vertex] && uv[vertex] != mesh.triangle_uv[i][corner]) return {};
      uv[vertex] = mesh.triangle_uv[i][corner];
      known[vertex] = true;
    }
  return uv;
}

/// The header and the elements of the file.
class PlyContents {
 public:
  PlyContents(const TriangleMesh& mesh, const VertexPaint& paint, const Vec3d& origin)
      : mesh_(mesh),
        paint_(paint),
        origin_(origin),
        vertex_uv_(vertex_uv(mesh)),
        inked_(shows_clay(paint.colours)) {}

  std::string header() const {
    std::string text =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh_.positions.size());
    for (const char* axis : {"x", "y", "z"})
      text += fmt::format("property {} {}\n", is_far() ? "double" : "float", axis);
    if (!vertex_uv_.empty()) text += "property float s\nproperty float t\n";
    if (!paint_.colours.empty())
      for (const char* channel : {"red", "green", "blue"})
        text += fmt::format("property uchar {}\n", channel);
    if (inked_)
      for (const char* channel : {"ink_red", "ink_green", "ink_blue", "ink_alpha"})
        text += fmt::format("property uchar {}\n", channel);
    if (!paint_.masks.empty()) text += "property float mask\n";
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", mesh_.triangles.size());
    if (has_corner_uv()) text += "property list uchar float texcoord\n";
    return text + "end_header\n";
  }

  void put_vertex(std::string& bytes, std::size_t vertex) const {
    for (int axis = 0; axis < 3; ++axis) {
      const float coordinate = mesh_.positions[vertex][axis];
      is_far() ? put_number(bytes, coordinate + origin_[axis]) : put_number(bytes, coordinate);
    }
    if (!vertex_uv_.empty()) put_number(bytes, vertex_uv_[vertex]);
    if (!paint_.colours.empty()) put_bytes(bytes, bytes_over_clay(paint_.colours[vertex]), 3);
    if (inked_) put_bytes(bytes, paint_.colours[vertex], 4);
    if (!paint_.masks.empty()) put_number(bytes, paint_.masks[vertex]);
  }

  void put_face(std::string& bytes, std::size_t triangle) const {
    bytes.push_back(3);
    for (const Index vertex : mesh_.triangles[triangle]) put_little_endian(bytes, vertex);
    if (!has_corner_uv()) return;
    bytes.push_back(6);
    for (const Vec2f& uv : mesh_.triangle_uv[triangle]) put_number(bytes, uv);
  }

 private:
  bool is_far() const { return !origin_.isZero(0); }
  bool has_corner_uv() const { return vertex_uv_.empty() && !mesh_.triangle_uv.empty(); }

  const TriangleMesh& mesh_;
  const VertexPaint& paint_;
  const Vec3d& origin_;
  std::vector<Vec2f> vertex_uv_;
  bool inked_;  ///< some colours cover the clay only in part
};

/// Writes elements in chunks, which avoids a stream call per number as well as the whole file in memory.
template <class Put>
void write_elements(std::ostream& out, std::size_t count, const Put& put_element) {
  std::string bytes;
  for (std::size_t begin = 0; begin < count; begin += elements_per_chunk) {
    bytes.clear();
    for (std::size_t i = begin; i < std::min(begin + elements_per_chunk, count); ++i) put_element(bytes, i);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace

void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin) {
  const PlyContents contents(mesh, paint, origin);
  write_file_whole(path, [&](std::ostream& out) {
    out << contents.header();
    write_elements(out, mesh.positions.size(),
                   [&](std::string& bytes, std::size_t i) { contents.put_vertex(bytes, i); });
    write_elements(out, mesh.triangles.size(),
                   [&](std::string& bytes, std::size_t i) { contents.put_face(bytes, i); });
  });
}

}  // namespace burin
