#pragma once
#include <burin/surface/point_set.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/surface/vertex_paint.h>

#include <filesystem>

namespace burin {

/// Reads OBJ (polygons, texture coordinates, colours, subdivision tags), PLY, STL, OFF, glTF or GLB, told
/// apart by the extension. The vertex order is the file's; of an STL file, which shares no vertices, weld()
/// joins equal positions, in order of first appearance. Throws FileError naming the line, or the face or
/// vertex counted from 1: unreadable, truncated, an index out of range, a coordinate that is not finite, no
/// face at all, a colour or mask out of its range.
///
/// Places farther from the file's origin than 16 times their extent are counted from a near one, which
/// PolygonMesh::origin gives, so that as floats they keep what digits the file has.
///
/// Colours are sRGB. Of PLY files those of the vertices are read: red, green, blue (integers to 255, ushort
/// to 65535, floating point to 1), alpha, the coverage, 1 where it is missing, and mask, 0 to 1; of OBJ files
/// three numbers behind the coordinates, to 1, or to 255 where any is above 1. What write_mesh() keeps of
/// colours that cover the clay in part is preferred to what they look like, unless the two do not go
/// together. Texture coordinates as PlyTexture says, and of OBJ files.
PolygonMesh read_mesh(const std::filesystem::path& path);

/// Whether a file holds points instead of a mesh: a PLY file without faces. Throws FileError like read_mesh.
bool holds_points(const std::filesystem::path& path);

/// Reads such a file, in its order. Throws FileError: as read_mesh, or without normals (nx, ny, nz).
PointSet read_points(const std::filesystem::path& path);

/// Writes a mesh whole or not at all, in the format that the extension names: .ply, .glb, .obj or .off.
/// Positions are counted from `origin`, which is added. Colours are what they look like over clay, opaque,
/// and beside these, where any lets the clay be seen, as they are, which read_mesh() reads back bit for bit.
/// Throws FileError; ContractError for arrays of another length than the positions or triangles.
/// - PLY: binary, little-endian. Properties red, green, blue, ink_red, ink_green, ink_blue, ink_alpha
///   and mask where they are painted; texture coordinates as properties s and t of the vertices where
///   triangles agree at them, else as lists texcoord of the faces. Coordinates are doubles where the
///   origin is not zero.
/// - GLB: positions, smooth normals, TEXCOORD_0, COLOR_0 (linear, opaque), _INK (sRGB and coverage)
///   and _MASK. Vertices are split where triangles disagree on texture coordinates. The origin is the
///   node's translation.
/// - OBJ: text, with texture coordinates and what colours look like where they are painted. Colours
///   themselves and masks have no place in it.
/// - OFF: text, with what colours look like where they are painted. Colours themselves, masks and
///   texture coordinates have no place in it.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint = {},
                const Vec3d& origin = Vec3d::Zero());

/// Throws FileError when write_mesh() knows no format for this path.
void check_mesh_format(const std::filesystem::path& path);

}  // namespace burin
