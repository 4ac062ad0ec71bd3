#pragma once
#include <burin/base/file.h>
#include <burin/surface/files/file_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace burin {

/// Reads a whole mesh file of up to 32 GB, the size of scans with hundreds of millions of triangles. The
/// limit stops endless pipes. Throws FileError.
inline std::string read_mesh_bytes(const std::filesystem::path& path) {
  constexpr std::uintmax_t most = std::uintmax_t{1} << 35;
  return read_file(path, most);
}

/// The readers behind read_mesh(), one per format. They check what is specific to the format; read_mesh()
/// checks the mesh. They throw FileError.
FileMesh read_obj(const std::filesystem::path& path);
FileMesh read_ply(const std::filesystem::path& path);
FileMesh read_stl(const std::filesystem::path& path);
FileMesh read_off(const std::filesystem::path& path);
FileMesh read_gltf(const std::filesystem::path& path);

/// Whether the header of a PLY file announces faces, or a range grid, whose points would have to be joined to
/// faces.
bool has_ply_faces(const std::filesystem::path& path);

/// Reads the vertices of a PLY file and their normals, which must be there.
FilePoints read_ply_points(const std::filesystem::path& path);

/// The writers behind write_mesh(), one per format. They throw FileError.
void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);
void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);
void write_off(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);
void write_glb(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin);

}  // namespace burin
