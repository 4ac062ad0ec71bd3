#pragma once
#include <burin/remesh/patch_mesh.h>

#include <map>
#include <utility>

namespace burin::test {

/// The square from 0 to `cells` in the plane z = 0, two triangles a unit; the vertices of its border are
/// fixed.
inline PatchMesh flat_patch(int cells) {
  PatchMesh patch;
  const auto number = [&](int i, int j) { return static_cast<Index>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      patch.positions.emplace_back(i, j, 0);
      const bool border = i == 0 || j == 0 || i == cells || j == cells;
      patch.kept.push_back(border ? number(i, j) : no_index);
    }
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      patch.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      patch.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return patch;
}

/// Twice the area of a patch in the plane z = 0; triangles that are turned over count as negative.
inline double twice_area(const PatchMesh& patch) {
  double area = 0;
  for (const auto& [a, b, c] : patch.triangles)
    area += (patch.positions[b] - patch.positions[a]).cross(patch.positions[c] - patch.positions[a]).z();
  return area;
}

/// Sides of triangles that no other triangle has in the other direction; -1 where several have one in the
/// same.
inline int border_sides(const PatchMesh& patch) {
  std::map<std::pair<Index, Index>, int> sides;
  for (const Triangle& t : patch.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (++sides[{t[i], t[(i + 1) % 3]}] > 1) return -1;
  int open = 0;
  for (const auto& [side, count] : sides) open += sides.contains({side.second, side.first}) ? 0 : 1;
  return open;
}

/// Where divide() leaves points that it makes: where they are.
inline Vec3d same(const Vec3d& p) { return p; }

}  // namespace burin::test
