// Makes a grid of quads, each cut into two triangles.
#include "input/grid_mesh.h"

namespace burin {

TriangleMesh grid_mesh(Index columns, Index rows, const std::function<Vec3f(double u, double v)>& place) {
  TriangleMesh mesh;
  for (Index row = 0; row <= rows; ++row)
    for (Index column = 0; column <= columns; ++column)
      mesh.positions.push_back(place(2.0 * column / columns - 1, 2.0 * row / rows - 1));
  for (Index row = 0; row < rows; ++row)
    for (Index column = 0; column < columns; ++column) {
      const Index low = row * (columns + 1) + column, high = low + columns + 1;
      mesh.triangles.push_back({low, low + 1, high + 1});
      mesh.triangles.push_back({low, high + 1, high});
    }
  return mesh;
}

}  // namespace burin
