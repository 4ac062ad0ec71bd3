#pragma once
#include <burin/chart/dabs/dab.h>
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/surface.h>

namespace burin {

/// How far, in spacings, the chart of a base surface must reach beyond a dab, for the vertices at its rim to
/// have nodes on all sides.
inline constexpr double dab_margin = 2.5;

/// Carries a dab of a base surface, whose chart must reach dab_margin farther, over to the vertices of
/// the surface: each has the coordinates of its foot on the base surface, of the quadratic that fits the
/// nodes around the one of its cluster best. Makes nodes of the base as needed. On all threads; the result
/// does not depend on their number.
DabChart carried_dab(BaseSurface& base, const Surface& surface, const DabChart& nodes, double radius);

}  // namespace burin
