#pragma once
#include <burin/surface/point_set.h>
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/surface/vertex_paint.h>

#include <filesystem>

// The functions may be called on any thread, also on several at once, but not on a file that one of them
// writes.
namespace burin {

/// Reads a mesh from an OBJ (polygons, texture coordinates, colours, subdivision tags), PLY, STL, OFF, glTF
/// or GLB file; the extension selects the format. Vertices keep the file's order. STL files share no
/// vertices, so find_welds() and weld() join equal positions, in order of first appearance. Throws FileError,
/// which gives the line, or the face or vertex counted from 1, if the file is unreadable or truncated, if an
/// index, colour or mask is out of range, if a coordinate is not finite, or if there is no face.
///
/// Positions farther from the file's origin than 16 times their extent are stored relative to a nearer
/// origin, PolygonMesh::origin, so that floats keep the file's digits.
///
/// Colours are sRGB. PLY files have them as vertex properties: red, green and blue (integers up to 255,
/// ushort up to 65535, floating point up to 1), alpha (coverage, 1 if missing), and mask (0 to 1). OBJ files
/// have three numbers after the coordinates (up to 1, or up to 255 if any is above 1), or ZBrush's comments
/// (ObjPolypaint). Where write_mesh() stored partly covering colours besides their appearance over clay, they
/// are preferred unless they contradict the appearance. Texture coordinates are read from OBJ and glTF files
/// and from the PLY properties that PlyTexture lists.
PolygonMesh read_mesh(const std::filesystem::path& path);

/// Whether a file holds points instead of a mesh: a PLY file without faces. Throws FileError if the file or
/// its header is unreadable.
bool holds_points(const std::filesystem::path& path);

/// Reads a PLY file without faces as points, in the file's order. Throws FileError as read_mesh() does, and
/// if the points have no normals (nx, ny, nz).
PointSet read_points(const std::filesystem::path& path);

/// Writes a mesh, wholly or not at all, in the format that the extension selects: .ply, .glb, .obj or .off.
/// `origin` is added to all positions. Colours are written as they appear over clay, opaque. If any colour
/// covers the clay only in part, PLY and GLB hold the colours themselves as well, which read_mesh() restores
/// bit for bit. Throws FileError; ContractError if an array has neither no element nor one per vertex or
/// triangle.
/// - PLY: binary, little-endian. Painted vertices have the properties red, green, blue, ink_red, ink_green,
///   ink_blue, ink_alpha and mask. Texture coordinates are vertex properties s and t if triangles agree on
///   them at every vertex, else face lists texcoord. Coordinates are doubles if the origin is not zero.
/// - GLB: positions, smooth normals, TEXCOORD_0, COLOR_0 (linear, opaque), _INK (sRGB and coverage)
///   and _MASK. Vertices are split where triangles disagree on texture coordinates. The origin is the
///   node's translation.
/// - OBJ: text, with texture coordinates and colours as they appear. It cannot hold coverage and masks.
/// - OFF: text, with colours as they appear. It cannot hold coverage, masks and texture coordinates.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint = {},
                const Vec3d& origin = Vec3d::Zero());

/// Throws FileError if write_mesh() does not support the format of this path.
void check_mesh_format(const std::filesystem::path& path);

}  // namespace burin
