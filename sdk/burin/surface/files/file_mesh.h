#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// A mesh as its reader finds it: the places of its vertices are not yet floats.
struct FileMesh {
  std::vector<Vec3d> places;  ///< [vertex] object units, from the file's own origin on
  PolygonMesh mesh;           ///< without positions and origin
};

/// Points likewise.
struct FilePoints {
  std::vector<Vec3d> places;
  std::vector<Vec3f> normals;  ///< outward, any length, one a point
};

/// Where to count positions from so that floats hold them: zero unless the places lie more than 16 times the
/// diagonal of their box away from it, else a place among them whose coordinates are multiples of a power of
/// two near that diagonal, so that adding it to floats gives doubles without rounding. Places that are not
/// finite do not count.
Vec3d near_origin(const std::vector<Vec3d>& places);

/// The places from `origin` on, as floats.
std::vector<Vec3f> positions_from(const std::vector<Vec3d>& places, const Vec3d& origin);

}  // namespace burin
