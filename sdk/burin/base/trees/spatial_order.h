#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// The indices of points in the order of a Hilbert curve through their bounding box, so that neighbours in
/// space become neighbours in memory. Points of one cell are ordered by index. The curve has 2^k cells per
/// side, with k at least 10. Positions must be finite. The result depends on the points alone.
std::vector<Index> spatial_order(std::span<const Vec3f> points);

}  // namespace burin
