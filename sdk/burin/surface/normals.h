#pragma once
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <span>

namespace burin {

/// Normal at a vertex of a surface whose vertices stand at `positions`: the triangles' normals weighted
/// by the sine of their angle at the vertex over the lengths of their edges there, unit: exact for vertices
/// on a sphere, and hardly moved by slivers [Max 1999, Weights for Computing Vertex Normals from Facet
/// Normals]. Degenerate triangles count for nothing; where nothing is left the normal is (0, 0, 1).
Vec3f vertex_normal(const Surface& surface, std::span<const Vec3f> positions, Index vertex);

/// Sets normals[v] for all v in `vertices`, in parallel.
void update_normals(const Surface& surface, std::span<const Vec3f> positions, std::span<const Index> vertices,
                    std::span<Vec3f> normals);

/// The vertex normals interpolated to a point of the surface, unit.
Vec3f normal_at(const Surface& surface, const SurfacePoint& point);

}  // namespace burin
