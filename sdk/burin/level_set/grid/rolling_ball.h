#pragma once
#include <burin/level_set/grid/grids.h>

namespace burin {

/// Fills the groove between two solids with what a ball of this radius, object units, that rolls along both
/// cannot reach. `both`: their union, of which values within the fillet become less. The three have the same
/// leaves; values of each solid are distances, at least as far as two radii from it.
void add_fillet(Grid& both, const Grid& first, const Grid& second, double radius);

}  // namespace burin
