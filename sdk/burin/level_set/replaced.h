#pragma once
#include <burin/remesh/patch_mesh.h>
#include <burin/surface/surface.h>

#include <Eigen/Geometry>

#include <functional>
#include <vector>

namespace burin {

/// Which triangles of a surface give way to others around a solid. Object units.
struct Replacement {
  const Surface& surface;
  const std::vector<Index>& candidates;  ///< triangles, ascending; no other one is near
  PointField beyond;                     ///< distance from the solid on the side on which the surface stays
  double known;                          ///< the greatest that `beyond` tells
  Eigen::AlignedBox3d box;               ///< outside of which the solid is farther than `known`
  double near;                           ///< triangles are replaced of which a part is nearer than this
  double voxel;                          ///< how exactly that is looked for
  PointField size;                       ///< of the edges that are to be there afterwards
};

/// The triangles of a surface whose boxes reach into a box, ascending. On all threads.
std::vector<Index> triangles_within(const Surface& surface, const Eigen::AlignedBox3d& box);

/// Those triangles, ascending; and others beyond sides that are too long for what is to come beside them, so
/// that these can be split. On all threads.
std::vector<Index> replaced_triangles(const Replacement& replacement);

/// These triangles by themselves, ascending. Vertices that others have too are kept, and those that `keep`
/// says. Throws Error with the place where the surface is open or no manifold.
PatchMesh piece_of(const Surface& surface, const std::vector<Index>& triangles,
                   const std::function<bool(const Vec3d&)>& keep);

}  // namespace burin
