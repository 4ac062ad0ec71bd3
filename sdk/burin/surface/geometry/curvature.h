#pragma once
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// Gauss curvature at a vertex, 1 / length^2. On a mesh it is the area that the vertex normals of the
/// triangles around sweep on the unit sphere, over the area of these triangles. On a point set it is the
/// determinant of the shape operator that best fits the normals of the neighbours. Zero where there is no
/// area.
float gauss_curvature(const Surface& surface, Index vertex);

/// Sets surface.gauss_curvature of all vertices, in parallel.
void compute_gauss_curvature(Surface& surface);

/// Sets surface.gauss_curvature of these vertices, in parallel.
void update_gauss_curvature(Surface& surface, std::span<const Index> vertices);

}  // namespace burin
