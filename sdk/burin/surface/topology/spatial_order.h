#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// The points' indices in the order of a Hilbert curve through their bounding box, points of one cell by
/// index: neighbours in space become neighbours in memory. Cells are 2^k to a side, k = 10 at least.
/// Positions must be finite. The result depends on the points alone.
std::vector<Index> spatial_order(std::span<const Vec3f> points);

}  // namespace burin
