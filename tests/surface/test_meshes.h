#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cmath>
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

/// A disc of radius 1 in the plane z = 0 around a hub, vertex 0, with this many spokes.
inline TriangleMesh fan(Index spokes) {
  TriangleMesh mesh;
  mesh.positions.push_back(Vec3f::Zero());
  for (Index i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / spokes;
    mesh.positions.push_back(Vec3d(std::cos(angle), std::sin(angle), 0).cast<float>());
    mesh.triangles.push_back({0, i + 1, (i + 1) % spokes + 1});
  }
  return mesh;
}

}  // namespace burin::test
