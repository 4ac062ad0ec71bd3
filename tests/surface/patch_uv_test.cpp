#include <burin/surface/patch_uv.h>
#include <burin/surface/surface_patch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/shapes.h"

namespace burin {
namespace {

/// (x, y) to the left of x = 0; to the right of it, beyond a seam, 10 more. Kinked: in the upper half v grows
/// twice as fast.
Vec2f uv_at(const Vec3f& p, bool right) {
  return {p.x() + (right ? 10.0F : 0.0F), p.y() > 0 ? 2 * p.y() : p.y()};
}

bool is_right(const std::array<Vec3f, 3>& corners) {
  return corners[0].x() + corners[1].x() + corners[2].x() > 0;
}

/// A plane around the origin whose edges run along both axes.
Surface plane_with_uv() {
  TriangleMesh mesh;
  constexpr int side = 12;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j)
      mesh.positions.emplace_back(static_cast<float>(i - side / 2), static_cast<float>(j - side / 2), 0.0F);
  const auto at = [](int i, int j) { return static_cast<Index>(i * (side + 1) + j); };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  for (const Triangle& t : mesh.triangles) {
    const std::array corners = {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
    TriangleUv& uv = mesh.triangle_uv.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) uv[i] = uv_at(corners[i], is_right(corners));
  }
  return make_surface(mesh);
}

/// Puts a fan around a point instead of the square within two units.
SurfacePatch fan(const Surface& surface, const Vec3f& middle) {
  SurfacePatch patch;
  patch.positions = {middle};
  std::set<std::pair<Index, Index>> sides;
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& triangle = surface.triangles[t];
    if (!std::ranges::all_of(triangle,
                             [&](Index v) { return surface.positions[v].cwiseAbs().maxCoeff() < 2.5F; }))
      continue;
    patch.removed.push_back(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair side{triangle[i], triangle[(i + 1) % 3]};
      if (sides.erase({side.second, side.first}) == 0) sides.insert(side);
    }
  }
  for (const auto& [from, to] : sides) patch.triangles.push_back({from, to, surface.vertex_count()});
  return patch;
}

TEST(CarriedUv, IsThatOfTheIslandUnderATrianglesMiddle) {
  const Surface surface = plane_with_uv();
  const Picker picker(surface);
  SurfacePatch patch = fan(surface, Vec3f(0.3F, 0, 0));
  ASSERT_EQ(patch.triangles.size(), 16u);
  patch.triangle_uv = carried_uv(surface, picker, patch);
  ASSERT_EQ(patch.triangle_uv.size(), 16u);
  const Surface after = patched(surface, patch).surface;
  ASSERT_EQ(after.triangle_uv.size(), after.triangles.size());
  std::size_t across = 0;
  for (Index t = 0; t < after.triangles.size(); ++t) {
    std::array<Vec3f, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = after.positions[after.triangles[t][i]];
    const auto [left, right] = std::ranges::minmax(corners, {}, [](const Vec3f& p) { return p.x(); });
    if (left.x() < 0 && right.x() > 0) ++across;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LT((after.triangle_uv[t][i] - uv_at(corners[i], is_right(corners))).norm(), 1e-5F)
          << corners[i].transpose();
  }
  EXPECT_GT(across, 2u) << "no new triangle lies across the seam";
}

TEST(CarriedUv, IsNothingWhereThereIsNone) {
  Surface surface = plane_with_uv();
  surface.triangle_uv = {};
  EXPECT_TRUE(carried_uv(surface, Picker(surface), fan(surface, Vec3f::Zero())).empty());
}

}  // namespace
}  // namespace burin
