#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cstdint>

namespace burin {

/// A surface of few vertices that can be described in a line.
struct FuzzSurface {
  enum class Shape { sheet, tube, ball };
  Shape shape = Shape::sheet;     ///< of half width or radius 1
  Index columns = 12, rows = 12;  ///< of its net of quads
  double relief = 0;              ///< height of its hills, object units
  double holes = 0;               ///< share of its triangles that it lacks
  std::uint64_t seed = 0;         ///< of where
};

/// The point of the surface at (u, v), both from -1 to 1, before it was made of triangles.
Vec3d surface_point(const FuzzSurface& surface, double u, double v);
TriangleMesh surface_mesh(const FuzzSurface& surface);

}  // namespace burin
