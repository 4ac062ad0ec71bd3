#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cmath>

namespace burin::test {

/// A square with hills, 0.04 from vertex to vertex; hills and triangles are mirrored at x = 0.
inline TriangleMesh mirrored_hills() {
  constexpr int half = 18;
  TriangleMesh mesh;
  for (int row = -half; row <= half; ++row)
    for (int column = -half; column <= half; ++column) {
      const float x = 0.04f * static_cast<float>(column), y = 0.04f * static_cast<float>(row);
      mesh.positions.emplace_back(x, y, 0.04f * std::cos(5 * x) * std::sin(4 * y + 1));
    }
  const auto number = [](int column, int row) { return static_cast<Index>(row * (2 * half + 1) + column); };
  for (int row = 0; row < 2 * half; ++row)
    for (int column = 0; column < 2 * half; ++column) {
      const Index a = number(column, row), b = number(column + 1, row), c = number(column + 1, row + 1),
                  d = number(column, row + 1);
      const bool right = column >= half;
      mesh.triangles.push_back(right ? Triangle{a, b, c} : Triangle{a, b, d});
      mesh.triangles.push_back(right ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  return mesh;
}

}  // namespace burin::test
