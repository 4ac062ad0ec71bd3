#pragma once
#include <filesystem>

namespace burin {

/// Checks the lines of vertices, texture coordinates and faces of an OBJ file. tinyobjloader reads anything
/// that is not a number as 0 and keeps no line numbers, so a damaged file would pass for a mesh. Throws
/// FileError naming the line.
void check_obj_lines(const std::filesystem::path& path);

}  // namespace burin
