#pragma once
#include <burin/surface/triangle_mesh.h>

#include <numbers>

namespace burin::test {

/// A torus about z, radii 2 and 0.7, of `rows` x `columns` quads, each split into two triangles.
inline TriangleMesh torus(Index rows, Index columns) {
  TriangleMesh mesh;
  const auto angle = [](Index i, Index n) { return 2 * std::numbers::pi * i / n; };
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) {
      const double a = angle(i, rows), b = angle(j, columns), r = 2 + 0.7 * std::cos(b);
      mesh.positions.push_back(Vec3d(r * std::cos(a), r * std::sin(a), 0.7 * std::sin(b)).cast<float>());
    }
  const auto vertex = [&](Index i, Index j) { return i % rows * columns + j % columns; };
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) {
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

}  // namespace burin::test
