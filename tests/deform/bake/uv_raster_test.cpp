#include <burin/base/parallel.h>
#include <burin/deform/bake/uv_raster.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace burin {
namespace {

/// The square [low, high]^2 as two triangles.
std::vector<TriangleUv> square(float low, float high) {
  const Vec2f a(low, low), b(high, low), c(high, high), d(low, high);
  return {{a, b, c}, {a, c, d}};
}

std::vector<TriangleUv> random_triangles(std::size_t count, float size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-0.2F, 1.2F), step(-size, size);
  std::vector<TriangleUv> triangles;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2f corner(place(random), place(random));
    triangles.push_back(
        {corner, corner + Vec2f(step(random), step(random)), corner + Vec2f(step(random), step(random))});
  }
  return triangles;
}

double side(const Vec2f& a, const Vec2f& b, const Vec2d& p) {
  const Vec2d along = (b - a).cast<double>(), to = p - a.cast<double>();
  return along.x() * to.y() - along.y() * to.x();
}

/// Whether a point lies on the same side of all edges; `near` is set when it is too close to one to tell.
bool holds(const TriangleUv& t, const Vec2d& p, bool& near) {
  int left = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = side(t[i], t[(i + 1) % 3], p);
    near = near || std::abs(at) < 1e-6;
    left += at > 0 ? 1 : 0;
  }
  return left == 0 || left == 3;
}

TEST(UvRaster, GivesTheLowestTriangleThatHoldsACentre) {
  constexpr int size = 61;
  const std::vector<TriangleUv> triangles = random_triangles(60, 0.4F, 5);
  const UvRaster raster = rasterise(triangles, size);
  int compared = 0, covered = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const Vec2d centre((column + 0.5) / size, 1 - (row + 0.5) / size);
      bool near = false;
      Index expected = no_index;
      for (Index i = 0; i < triangles.size(); ++i)
        if (holds(triangles[i], centre, near)) expected = std::min(expected, i);
      if (near) continue;
      ++compared;
      covered += expected != no_index ? 1 : 0;
      const auto texel = static_cast<std::size_t>(row * size + column);
      EXPECT_EQ(raster.triangle[texel], expected) << row << " " << column;
      EXPECT_LE((raster.centre(texel) - centre).norm(), 1e-12);
    }
  EXPECT_GT(compared, 3000);
  EXPECT_GT(covered, compared / 3);
  EXPECT_LT(covered, compared);
  EXPECT_GT(raster.overlaps, 100U);
}

TEST(UvRaster, LeavesNoGapsAndNoOverlapsBetweenNeighbours) {
  std::vector<TriangleUv> triangles;
  constexpr int cells = 24;  // corners on texel centres, corners and neither
  const auto at = [](int x, int y) {
    return Vec2f(static_cast<float>(x) / cells, static_cast<float>(y) / cells);
  };
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  for (const int size : {1, 12, 24, 36, 100, 257}) {
    const UvRaster raster = rasterise(triangles, size);
    EXPECT_EQ(std::ranges::count(raster.triangle, no_index), 0) << size;
    EXPECT_EQ(raster.overlaps, 0U) << size;
  }
}

TEST(UvRaster, CountsTexelsOfSeveralTriangles) {
  std::vector<TriangleUv> triangles = square(0, 0.5F);
  for (const TriangleUv& triangle : square(0.25F, 1)) triangles.push_back(triangle);
  const UvRaster raster = rasterise(triangles, 40);
  EXPECT_LE(raster.overlaps, 100U);
  EXPECT_GE(raster.overlaps, 100U - 20);  // but for those on the diagonals
  EXPECT_LT(raster.triangle[39 * 40], 2U);
  EXPECT_GE(raster.triangle[39], 2U);
  EXPECT_EQ(raster.triangle[0], no_index);
}

TEST(UvRaster, LeavesOutWhatHasNoAreaOrLiesOutside) {
  const float huge = 1e30F;
  const std::vector<TriangleUv> triangles = {{Vec2f(0.1F, 0.1F), Vec2f(0.5F, 0.5F), Vec2f(0.9F, 0.9F)},
                                             {Vec2f(0.5F, 0.5F), Vec2f(0.5F, 0.5F), Vec2f(0.5F, 0.5F)},
                                             {Vec2f(2, 2), Vec2f(3, 2), Vec2f(2, 3)},
                                             {Vec2f(-huge, -huge), Vec2f(-huge, 0), Vec2f(-1, -1)}};
  const UvRaster raster = rasterise(triangles, 33);
  EXPECT_EQ(std::ranges::count(raster.triangle, no_index), 33 * 33);
  EXPECT_TRUE(std::ranges::all_of(rasterise({}, 5).triangle, [](Index t) { return t == no_index; }));
}

TEST(UvRaster, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<TriangleUv> triangles = random_triangles(3000, 0.05F, 9);
  const UvRaster expected = rasterise(triangles, 300);
  for (const std::size_t threads : {1, 3}) {
    const ThreadLimit limit(threads);
    const UvRaster raster = rasterise(triangles, 300);
    EXPECT_EQ(raster.triangle, expected.triangle);
    EXPECT_EQ(raster.overlaps, expected.overlaps);
  }
}

}  // namespace
}  // namespace burin
