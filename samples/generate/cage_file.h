#pragma once
#include <burin/surface/polygon_mesh.h>

#include <filesystem>
#include <string_view>

namespace burin::samples {

/// Writes an OBJ file with the cage's faces and `t crease` tags. `title` becomes its first comment.
void write_cage(const std::filesystem::path& path, std::string_view title, const PolygonMesh& cage);

}  // namespace burin::samples
