// Chooses the reader or writer of a mesh file by its extension, and checks what all formats have in common:
// finite positions, sizes of faces and numbers of vertices.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/weld_mesh.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace burin {
namespace fs = std::filesystem;

namespace {

void check_readable(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw FileError(path.string(), "is a folder, not a file");
  if (!std::ifstream(path)) throw FileError(path.string(), std::strerror(errno));
  const auto size = fs::file_size(path, error);
  if (error) throw FileError(path.string(), error.message());
  if (size == 0) throw FileError(path.string(), "is empty");
}

std::string extension_of(const fs::path& path) { return in_lower_case(path.extension().string()); }

FileMesh read_by_extension(const fs::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".obj") return read_obj(path);
  if (extension == ".ply") return read_ply(path);
  if (extension == ".stl") return read_stl(path);
  if (extension == ".off") return read_off(path);
  if (extension == ".gltf" || extension == ".glb") return read_gltf(path);
  throw FileError(path.string(),
                  fmt::format("{} is not a mesh format; .obj, .ply, .stl, .off, .gltf and .glb are",
                              quoted_word(extension)));
}

[[noreturn]] void fail_at(const fs::path& path, std::string_view element, std::size_t index,
                          std::string_view what) {
  throw FileError(path.string(), fmt::format("{} {}", element, index + 1), what);
}

void check_positions(const fs::path& path, const PolygonMesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!mesh.positions[i].allFinite()) fail_at(path, "vertex", i, "a coordinate is not finite");
}

void check_faces(const fs::path& path, const PolygonMesh& mesh) {
  if (mesh.face_sizes.empty()) throw FileError(path.string(), "has no face");
  std::size_t corner = 0;
  for (std::size_t face = 0; face < mesh.face_sizes.size(); ++face) {
    const Index size = mesh.face_sizes[face];
    if (size < 3) fail_at(path, "face", face, fmt::format("a face of {} corners", size));
    for (const std::size_t end = corner + size; corner < end; ++corner)
      if (mesh.face_vertices[corner] >= mesh.positions.size())
        fail_at(path, "face", face,
                fmt::format("names a vertex that is not among the {}", mesh.positions.size()));
  }
}

/// Joins the equal positions of a soup of triangles, and tells how many have no three corners then.
PolygonMesh joined(PolygonMesh soup) {
  const std::size_t faces = soup.face_sizes.size();
  const std::vector<Index> vertex_of = find_welds(soup, 0);
  PolygonMesh mesh = weld(std::move(soup), vertex_of);
  const std::size_t left_out = faces - mesh.face_sizes.size();
  if (left_out > 0)
    mesh.not_used += fmt::format("{}{} {} of fewer than three places", mesh.not_used.empty() ? "" : ", ",
                                 left_out, left_out == 1 ? "triangle" : "triangles");
  return mesh;
}

}  // namespace

PolygonMesh read_mesh(const fs::path& path) {
  check_readable(path);
  FileMesh file = read_by_extension(path);
  PolygonMesh mesh = std::move(file.mesh);
  mesh.origin = near_origin(file.places);
  mesh.positions = positions_from(file.places, mesh.origin);
  check_positions(path, mesh);
  check_faces(path, mesh);
  if (extension_of(path) != ".stl") return mesh;
  return joined(std::move(mesh));
}

bool holds_points(const fs::path& path) {
  check_readable(path);
  return extension_of(path) == ".ply" && !has_ply_faces(path);
}

PointSet read_points(const fs::path& path) {
  check_readable(path);
  FilePoints file = read_ply_points(path);
  PointSet points;
  points.origin = near_origin(file.places);
  points.positions = positions_from(file.places, points.origin);
  points.normals = std::move(file.normals);
  return points;
}

namespace {

using Writer = void (*)(const fs::path&, const TriangleMesh&, const VertexPaint&, const Vec3d&);

Writer writer_for(const fs::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return write_ply;
  if (extension == ".glb") return write_glb;
  if (extension == ".obj") return write_obj;
  if (extension == ".off") return write_off;
  throw FileError(path.string(), "meshes are written as .ply, .glb, .obj or .off files");
}

}  // namespace

void check_mesh_format(const fs::path& path) { writer_for(path); }

void write_mesh(const fs::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
                const Vec3d& origin) {
  const auto one_each = [](const auto& values, const auto& elements) {
    return values.empty() || values.size() == elements.size();
  };
  if (!one_each(paint.colours, mesh.positions) || !one_each(paint.masks, mesh.positions) ||
      !one_each(mesh.triangle_uv, mesh.triangles))
    throw ContractError("write_mesh: not one colour or mask a vertex, or texture coordinates a triangle");
  writer_for(path)(path, mesh, paint, origin);
}

}  // namespace burin
