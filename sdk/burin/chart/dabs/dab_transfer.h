#pragma once
#include <burin/chart/dabs/dab.h>
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/surface.h>

namespace burin {

/// By how many spacings of the base nodes a dab on the base surface must be larger than the dab on the
/// surface, so that the vertices at the rim have nodes on all sides.
inline constexpr double dab_margin = 2.5;

/// Interpolates a dab on a base surface, which must be larger by dab_margin, to the vertices of the surface.
/// A vertex gets the coordinates of its foot point on the base surface from a quadratic fitted to the nodes
/// around the node of its cluster. Runs on all threads; the result does not depend on their number.
DabChart transferred_dab(BaseSurface& base, const Surface& surface, const DabChart& nodes, double radius);

}  // namespace burin
