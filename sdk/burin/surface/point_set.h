#pragma once
#include <burin/base/progress.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <vector>

namespace burin {

/// Oriented points in the order of a file.
struct PointSet {
  std::vector<Vec3f> positions;  ///< object units, from `origin` on
  std::vector<Vec3f> normals;    ///< outward, any length, one a point
  Vec3d origin = Vec3d::Zero();  ///< as PolygonMesh::origin
};

/// Links a point unless told.
inline constexpr std::size_t default_links = 12;

/// A surface without triangles for stroke and dab charts: sorted like a mesh, normals as given, neighbours
/// the `links` nearest points of each, in both directions. Points whose normals stand more than 120 degrees
/// apart are no neighbours, and do not count among the nearest: they lie on both sides of a part thinner
/// than the points' distance, and a link would short-circuit it. (On an edge sharper than 60 degrees the
/// sides stay apart likewise, unless points on it have normals between.)
/// Throws Error naming the point, counted from 1: a coordinate that is not finite, a normal that is not
/// finite or zero; Error for fewer than 3 points, ContractError for as many normals as not points or fewer
/// than 3 links.
Surface make_point_surface(PointSet points, std::size_t links = default_links, const Progress& progress = {});

}  // namespace burin
