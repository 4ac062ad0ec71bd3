#pragma once
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// Gauss curvature around a vertex, 1 / length^2: the area that the normals of its triangles' corners sweep
/// on the unit sphere over the area of the triangles. Zero where there is no area, or where the normals
/// turn by more than a triangle can tell.
float gauss_curvature(const Surface& surface, Index vertex);

/// Sets surface.gauss_curvature of these vertices, in parallel.
void update_gauss_curvature(Surface& surface, std::span<const Index> vertices);

}  // namespace burin
