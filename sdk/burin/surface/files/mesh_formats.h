#pragma once
#include <burin/base/file.h>
#include <burin/surface/files/file_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace burin {

/// A whole file that holds a mesh. Scans of hundreds of millions of triangles are as large as this; what
/// comes through a pipe without end is larger. Throws FileError.
inline std::string read_mesh_bytes(const std::filesystem::path& path) {
  constexpr std::uintmax_t most = std::uintmax_t{1} << 35;
  return read_file(path, most);
}

/// The readers behind read_mesh, one a format. They check what only the format knows; read_mesh checks the
/// mesh. Throw FileError.
FileMesh read_obj(const std::filesystem::path& path);
FileMesh read_ply(const std::filesystem::path& path);
FileMesh read_stl(const std::filesystem::path& path);
FileMesh read_off(const std::filesystem::path& path);
FileMesh read_gltf(const std::filesystem::path& path);

/// Of a PLY file: whether its header announces faces, or a grid of points that would have to be joined to
/// faces, and its vertices with their normals.
bool has_ply_faces(const std::filesystem::path& path);
FilePoints read_ply_points(const std::filesystem::path& path);

/// The writers behind write_mesh, likewise.
void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);
void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);
void write_off(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);
void write_glb(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);

}  // namespace burin
