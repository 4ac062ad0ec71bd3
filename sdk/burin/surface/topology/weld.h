#pragma once
#include <burin/base/vector.h>

#include <span>
#include <vector>

namespace burin {

/// For every point the lowest index of a point at the same place; 0 and -0 are one place.
std::vector<Index> first_at_place(std::span<const Vec3f> points);

}  // namespace burin
