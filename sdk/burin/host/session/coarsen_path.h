#pragma once
#include <burin/deform/paint.h>
#include <burin/host/session.h>
#include <burin/host/session/stroke_lines.h>
#include <burin/refine/near_vertices.h>

#include <span>
#include <vector>

namespace burin {

/// By how much longer the edges that a stroke needs must be than those for which a vertex was added, for the
/// stroke to take it out.
inline constexpr double coarsen_factor = 2;

/// What a stroke made of a surface, which is still as it was before.
struct DrawnStroke {
  const std::vector<std::vector<Vec3d>>& pieces;  ///< the places of the surface that it went through
  std::span<const Vec3f> positions;               ///< [vertex] with the stroke, object units
  std::span<const Index> displaced;               ///< vertices that it moved
  const Paint& paint;                             ///< with the stroke
};

/// What a surface with a finished stroke has more of than the stroke needs.
struct PathCoarsening {
  Surface drawn;       ///< the surface at the positions of the stroke, if it is to be patched
  SurfacePatch patch;  ///< of that, without new vertices; empty where nothing goes
  KeptEdges kept;      ///< vertices of the surface that were looked at, and the length of edges of the stroke
  double seconds = 0;  ///< that it took to find
};

/// Finds vertices that refinements added within the stroke's reach, for edges of at most half the length that
/// the stroke needs, and were not looked at for as long ones since; and what is left of them when all go that
/// the shape and the paint can do without. Shapes stay within a hundredth of the length, and where the
/// settings name an error, within a quarter of it. What later strokes with shorter edges will need stays;
/// they are asked for only if there is anything to do. Costs O(1) where nothing was refined finer, and
/// O(vertices within reach) where that is elsewhere.
PathCoarsening coarsened_along(const StrokeGround& ground, const StrokeSettings& settings,
                               const DrawnStroke& stroke, const LaterStrokes& later, NearVertices& near);

}  // namespace burin
