#pragma once
#include <burin/refine/edge_length.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// What refines a surface.
struct SurfaceRefinement {
  SurfacePatch patch;
  std::vector<Vec3f> given;  ///< [new vertex] where it would be if nothing was drawn, object units
  std::vector<float> edges;  ///< [new vertex] how long edges may be there, object units
};

/// Splits edges that are more than longest_edge_factor times as long as they may be, until there is none. The
/// patch is empty where there is none before: so a second refinement for the same lengths changes nothing.
/// Edges are as long as they were on the surface as it was given (`given`: [vertex] its place then; empty:
/// where it is), if they are longer now.
/// Sharp edges and borders keep their places; new vertices lie on flat facets, or on the smooth surface that
/// curved ones stand for (smooth_facets.h). Nothing moves that was there. Searches from the triangles of
/// `seeds` on, over the surface within the radius of the lengths. Costs what is refined, whatever the size of
/// the surface; the result is a function of surface, lengths and seeds. Throws Error where there would be
/// more than `most_triangles` new ones.
SurfaceRefinement refine_surface(const Surface& surface, const EdgeLength& lengths,
                                 std::span<const Index> seeds, std::size_t most_triangles,
                                 std::span<const Vec3f> given = {});

/// How much longer than EdgeLength says edges may stay.
inline constexpr double longest_edge_factor = 4. / 3;

}  // namespace burin
