#pragma once
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// Gauss curvature around a vertex, 1 / length^2: the area that the normals of its triangles' corners sweep
/// on the unit sphere over the area of the triangles; of a point set, the determinant of the shape operator
/// that fits the normals of its neighbours best. Zero where there is no area.
float gauss_curvature(const Surface& surface, Index vertex);

/// Sets surface.gauss_curvature of all vertices, in parallel.
void compute_gauss_curvature(Surface& surface);

/// Sets surface.gauss_curvature of these vertices, in parallel.
void update_gauss_curvature(Surface& surface, std::span<const Index> vertices);

}  // namespace burin
