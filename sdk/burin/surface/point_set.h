#pragma once
#include <burin/base/progress.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <vector>

// make_point_surface() may be called on any thread, also on several at once. Inside it uses all threads of
// oneTBB.
namespace burin {

/// Oriented points in the order of a file.
struct PointSet {
  std::vector<Vec3f> positions;  ///< object units, relative to `origin`
  std::vector<Vec3f> normals;    ///< [point] outward, any length
  Vec3d origin = Vec3d::Zero();  ///< see PolygonMesh::origin
};

/// The default number of links per point.
inline constexpr std::size_t default_links = 12;

/// Makes a surface without triangles, for stroke and dab charts. Points are sorted like the vertices of a
/// mesh, and each is linked, in both directions, with its `links` nearest points. Points whose normals differ
/// by more than 120 degrees are neither linked nor counted among the nearest: they lie on opposite sides of a
/// part thinner than the distance of the points, and a link would be a short circuit. (For the same reason
/// the sides of an edge sharper than 60 degrees are not linked, unless points on the edge have normals
/// between.) `progress` may be empty. Throws Error, which gives the point counted from 1, for a coordinate
/// that is not finite and for a normal that is zero or not finite; Error for fewer than 3 points;
/// ContractError if there are not as many normals as points, or for fewer than 3 links.
Surface make_point_surface(const PointSet& points, std::size_t links = default_links,
                           const Progress& progress = {});

}  // namespace burin
