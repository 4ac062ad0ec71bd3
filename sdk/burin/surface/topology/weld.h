#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// For every point the lowest index of a point with the same position; 0 and -0 are equal. Costs O(n log n),
/// on all threads.
std::vector<Index> first_at_position(std::span<const Vec3f> points);

}  // namespace burin
