#pragma once
#include <burin/surface/polygon_mesh.h>

#include <filesystem>

namespace burin {

/// The readers behind read_mesh, one a format. They check what only the format knows; read_mesh checks the
/// mesh. Throw FileError.
PolygonMesh read_obj(const std::filesystem::path& path);
PolygonMesh read_ply(const std::filesystem::path& path);
PolygonMesh read_stl(const std::filesystem::path& path);

}  // namespace burin
