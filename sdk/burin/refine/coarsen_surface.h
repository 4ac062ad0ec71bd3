#pragma once
#include <burin/refine/drawn_samples.h>
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// How coarse a surface may become.
struct CoarsenBounds {
  double edge;   ///< edges to aim at, object units; none gets more than longest_edge_factor times as long
  double apart;  ///< most distance from vertices and middles of triangles that there were
  IsLikeCorners is_like = {};  ///< what else vertices that go must fit; empty: nothing
};

/// Takes vertices from a surface where they make edges shorter than needed: each is moved onto a neighbour,
/// as long as that leaves nothing farther off than the bounds say. The vertices that are left keep their
/// places, so that shapes that were drawn lose nothing but what the bounds allow. Sharp edges, borders and
/// seams lose vertices along them only, no triangle turns over, triangles with angles of less than 20 degrees
/// become fewer and no thinner, and the topology stays, that of soups too. `vertices`: those that may go.
/// `given`: [vertex] its place on the surface as it was given, by which edges are judged as refine_surface()
/// does; empty: where it is. The patch has no new vertices, and is empty where nothing goes. The result is a
/// function of the arguments; costs O(n log n) for n vertices that may go.
SurfacePatch coarsen_surface(const Surface& surface, std::span<const Index> vertices,
                             const CoarsenBounds& bounds, std::span<const Vec3f> given = {});

}  // namespace burin
