#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// A mesh as its reader finds it, with positions in double precision.
struct FileMesh {
  std::vector<Vec3d> places;  ///< [vertex] position, object units, relative to the file's own origin
  PolygonMesh mesh;           ///< positions and origin are not set
};

/// A point set as its reader finds it, with positions in double precision.
struct FilePoints {
  std::vector<Vec3d> places;   ///< [point] position, object units, relative to the file's own origin
  std::vector<Vec3f> normals;  ///< [point] outward, any length
};

/// Chooses the origin for float positions. It is zero unless the positions lie farther from it than 16 times
/// the diagonal of their bounding box. Otherwise it lies among them, and its coordinates are multiples of a
/// power of two near that diagonal, so that origin + float is exact in double precision. Positions that are
/// not finite are ignored.
Vec3d near_origin(const std::vector<Vec3d>& places);

/// Converts positions to floats relative to `origin`.
std::vector<Vec3f> positions_from(const std::vector<Vec3d>& places, const Vec3d& origin);

}  // namespace burin
