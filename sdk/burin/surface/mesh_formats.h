#pragma once
#include <burin/surface/point_set.h>
#include <burin/surface/polygon_mesh.h>

#include <filesystem>

namespace burin {

/// The readers behind read_mesh, one a format. They check what only the format knows; read_mesh checks the
/// mesh. Throw FileError.
PolygonMesh read_obj(const std::filesystem::path& path);
PolygonMesh read_ply(const std::filesystem::path& path);
PolygonMesh read_stl(const std::filesystem::path& path);

/// Of a PLY file: whether its header announces faces, and its vertices with their normals.
bool has_ply_faces(const std::filesystem::path& path);
PointSet read_ply_points(const std::filesystem::path& path);

}  // namespace burin
