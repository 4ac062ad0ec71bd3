// What was refined is made coarser again: against the lengths that refinement gives, the shape that was
// there, and the topology, on planes, spheres, boxes with sharp edges and seams, and soups.
#include <burin/base/segment.h>
#include <burin/refine/coarsen_surface.h>
#include <burin/surface/topology/euler.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

#include "refined.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// A surface that was refined along a line, and which of its vertices that added.
struct Refined {
  explicit Refined(const Refinable& from) : Refined(patched(from.surface, from.refine()), from) {}

  /// All that may go within a distance of the line.
  std::vector<Index> added_within(double distance) const {
    std::vector<Index> found;
    for (const Index v : added)
      if (lengths.at(surface.positions[v].cast<double>()) <= lengths.edge() + EdgeLength::growth * distance)
        found.push_back(v);
    return found;
  }
  PatchedSurface coarsened(const CoarsenBounds& bounds) const {
    return patched(surface, coarsen_surface(surface, added, bounds));
  }

  Surface surface;
  EdgeLength lengths;
  std::vector<Index> added;

 private:
  Refined(PatchedSurface made, const Refinable& from)
      : surface(std::move(made.surface)), lengths(from.lengths) {
    for (Index v = 0; v < surface.vertex_count(); ++v)
      if (made.came_from[v] >= from.surface.vertex_count()) added.push_back(v);
  }
};

Refinable fine_plane() { return {plane(1, 0.25, 3), straight({-0.5, 0, 0}, {0.5, 0.1, 0}), 0.15, 0.01}; }

/// The greatest distance of the vertices of one surface from another one.
double farthest(const Surface& from, const Surface& to) {
  const Picker picker(to);
  double most = 0;
  for (Index v = 0; v < from.vertex_count(); ++v) {
    if (from.incident[v].empty()) continue;
    const Vec3f& p = from.positions[v];
    const auto at = picker.closest(p, std::numeric_limits<float>::max());
    most = std::max(most, static_cast<double>((at->position - p).norm()));
  }
  return most;
}

TEST(CoarsenSurface, GivesEdgesTheLongerLengthAndGoodAngles) {
  const Refined fine(fine_plane());
  constexpr double edge = 0.04;
  const Surface coarse = fine.coarsened({.edge = edge, .apart = 0.0004}).surface;
  const EdgeLength wider({straight({-0.5, 0, 0}, {0.5, 0.1, 0})}, 0.15, edge);
  const Shapes within(coarse, wider, false), before(fine.surface, fine.lengths, true),
      whole(coarse, wider, true);
  const Refinable directly(plane(1, 0.25, 3), straight({-0.5, 0, 0}, {0.5, 0.1, 0}), 0.15, edge);
  const Surface wanted = patched(directly.surface, directly.refine()).surface;
  const Shapes directly_within(wanted, wider, false);
  EXPECT_NEAR(static_cast<double>(within.edges.size()), static_cast<double>(directly_within.edges.size()),
              0.1 * static_cast<double>(directly_within.edges.size()));
  ASSERT_GT(within.edges.size(), 500u);
  EXPECT_GE(within.edges.front(), 0.4 * edge);
  EXPECT_LE(within.edges.back(), 1.4 * edge);
  EXPECT_GE(whole.angles.front(), std::min(20., before.angles.front()) - 1e-3);
  EXPECT_GE(within.first_percent(), 24);
  EXPECT_EQ(euler_characteristic(coarse), 1);
  EXPECT_EQ(farthest(fine.surface, coarse), 0);
}

std::vector<Vec3d> around_the_sphere() {
  std::vector<Vec3d> line;
  for (int i = 0; i <= 60; ++i)
    line.push_back(Vec3d(std::cos(0.02 * i), std::sin(0.02 * i), 0.3).normalized());
  return line;
}

TEST(CoarsenSurface, KeepsASphereWithinTheBound) {
  const Refined fine({sphere(3, 0.15, 1), around_the_sphere(), 0.15, 0.008});
  constexpr double apart = 0.00006;
  const Surface coarse = fine.coarsened({.edge = 0.032, .apart = apart}).surface;
  EXPECT_LT(2 * coarse.triangles.size(), fine.surface.triangles.size());
  EXPECT_LE(farthest(fine.surface, coarse), apart * (1 + 1e-4));
  EXPECT_GT(farthest(fine.surface, coarse), apart / 10);
  EXPECT_EQ(euler_characteristic(coarse), 2);
  // A cap of 0.4 of all that is off by the bound.
  EXPECT_NEAR(volume(coarse), volume(fine.surface), 0.4 * 3 * apart * volume(fine.surface));
  const Surface rough = fine.coarsened({.edge = 0.032, .apart = 20 * apart}).surface;
  EXPECT_LT(rough.triangles.size(), coarse.triangles.size());
}

TEST(CoarsenSurface, MovesNothingAndKeepsWhatMayNotGo) {
  const Refined fine(fine_plane());
  const std::vector<Index> may_go = fine.added_within(0);
  ASSERT_LT(may_go.size(), fine.added.size());
  const SurfacePatch patch = coarsen_surface(fine.surface, may_go, {.edge = 0.04, .apart = 0.0004});
  EXPECT_TRUE(patch.positions.empty());
  const auto [coarse, came_from] = patched(fine.surface, patch);
  std::vector<bool> is_left(fine.surface.vertex_count(), false);
  for (Index v = 0; v < coarse.vertex_count(); ++v) {
    ASSERT_EQ(coarse.positions[v], fine.surface.positions[came_from[v]]);
    is_left[came_from[v]] = true;
  }
  std::size_t gone = 0;
  for (Index v = 0; v < is_left.size(); ++v) {
    if (is_left[v]) continue;
    ++gone;
    EXPECT_TRUE(std::ranges::binary_search(may_go, v));
  }
  EXPECT_GT(2 * gone, may_go.size());
  // Triangles go only around vertices that went.
  for (const Index triangle : patch.removed)
    EXPECT_TRUE(std::ranges::any_of(fine.surface.triangles[triangle], [&](Index v) { return !is_left[v]; }));
}

TEST(CoarsenSurface, LeavesABoxABoxWithItsTexture) {
  TriangleMesh mesh = box({2, 1, 1});
  // Each triangle is an island: its coordinates are those of the box along two of the axes.
  const auto uv_of = [](const Vec3f& p, std::size_t island) {
    return Vec2f(p.x() + p.z() / 2 + 5 * static_cast<float>(island), p.y() - p.z() / 3);
  };
  for (std::size_t t = 0; t < 12; ++t) {
    TriangleUv uv;
    for (std::size_t i = 0; i < 3; ++i) uv[i] = uv_of(mesh.positions[mesh.triangles[t][i]], t);
    mesh.triangle_uv.push_back(uv);
  }
  std::vector<Vec3d> line = straight({1.5, 0.5, 1}, {2, 0.9, 1});
  for (const Vec3d& place : straight({2, 0.9, 1}, {2, 0.8, 0.3})) line.push_back(place);
  const Refined fine({std::move(mesh), line, 0.15, 0.01});
  const Surface coarse = fine.coarsened({.edge = 0.04, .apart = 0.0004}).surface;
  EXPECT_LT(4 * coarse.triangles.size(), fine.surface.triangles.size());
  EXPECT_EQ(euler_characteristic(coarse), 2);
  EXPECT_NEAR(volume(coarse), volume(fine.surface), 1e-5);
  std::size_t on_edge = 0;
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f& p = coarse.positions[coarse.triangles[t][i]];
      const auto island = static_cast<std::size_t>(std::floor((coarse.triangle_uv[t][i].x() + 0.01F) / 5));
      ASSERT_LT((coarse.triangle_uv[t][i] - uv_of(p, island)).norm(), 1e-4F);
      on_edge += p.x() == 2 && p.z() == 1;
    }
  EXPECT_GT(on_edge, 20u);
}

/// The edges of a surface that have one triangle.
std::set<std::pair<Index, Index>> border_of(const Surface& surface) {
  std::set<std::pair<Index, Index>> border;
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<Index, Index> edge = std::minmax(t[i], t[(i + 1) % 3]);
      if (!border.insert(edge).second) border.erase(edge);
    }
  return border;
}

// A notch of a border, which triangles could cover without being far from anything, stays one.
TEST(CoarsenSurface, KeepsABorderWithinTheBound) {
  Refined fine({plane(1, 0.25, 3), straight({1, -0.5, 0}, {1, 0.5, 0}), 0.15, 0.01});
  for (Vec3f& p : fine.surface.positions)
    if (p.x() > 0.8F) p.x() += 0.1F * (p.x() - 0.8F) * std::sin(30 * p.y());
  constexpr double apart = 0.0004;
  const Surface coarse = fine.coarsened({.edge = 0.04, .apart = apart}).surface;
  const auto border = border_of(coarse), before = border_of(fine.surface);
  EXPECT_LT(border.size(), before.size() - 20);
  for (const auto& [vertex, end] : before) {
    const Vec3d at = fine.surface.positions[vertex].cast<double>();
    double least = 1;
    for (const auto& [a, b] : border) {
      const Vec3d from = coarse.positions[a].cast<double>(), to = coarse.positions[b].cast<double>();
      least = std::min(least, (at - from - share_on_segment(from, to, at) * (to - from)).norm());
    }
    ASSERT_LE(least, apart * (1 + 1e-4));
  }
}

/// A ridge along a line, as strokes draw them.
float ridge(const Vec3f& at) { return 0.02F * std::exp(-at.y() * at.y() / (0.03F * 0.03F)); }

TEST(CoarsenSurface, KeepsTheShapeThatWasDrawnNotOneStepOfIt) {
  Refined fine(fine_plane());
  for (Vec3f& p : fine.surface.positions) p.z() = ridge(p);
  constexpr double apart = 0.0004;
  const Surface coarse = fine.coarsened({.edge = 0.04, .apart = apart}).surface;
  EXPECT_LT(2 * coarse.triangles.size(), fine.surface.triangles.size());
  EXPECT_LE(farthest(fine.surface, coarse), apart * (1 + 1e-4));
  const Surface all = fine.coarsened({.edge = 0.04, .apart = 1}).surface;
  EXPECT_GT(farthest(fine.surface, all), 5 * apart);
}

TEST(CoarsenSurface, KeepsWhatElseVerticesHave) {
  const Refined fine(fine_plane());
  const auto value = [&](Index v) { return fine.surface.positions[v].y() > 0.02F ? 1. : 0.; };
  const IsLikeCorners is_like = [&](Index v, const Triangle& corners, const std::array<double, 3>& weights) {
    double mean = 0;
    for (std::size_t i = 0; i < 3; ++i) mean += weights[i] * value(corners[i]);
    return std::abs(mean - value(v)) <= 0.01;
  };
  const PatchedSurface plain = fine.coarsened({.edge = 0.04, .apart = 0.0004}),
                       kept = fine.coarsened({.edge = 0.04, .apart = 0.0004, .is_like = is_like});
  EXPECT_LT(plain.surface.triangles.size(), kept.surface.triangles.size());
  EXPECT_LT(2 * kept.surface.triangles.size(), fine.surface.triangles.size());
  const Picker picker(kept.surface);
  for (Index v = 0; v < fine.surface.vertex_count(); ++v) {
    const auto at = picker.closest(fine.surface.positions[v], 1);
    double mean = 0;
    for (std::size_t i = 0; i < 3; ++i)
      mean += static_cast<double>(at->weights[i]) * value(kept.came_from[at->corners[i]]);
    ASSERT_NEAR(mean, value(v), 0.02);
  }
}

TEST(CoarsenSurface, KeepsTheTopologyOfAnySoup) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::size_t removed = 0;
  for (int i = 0; i < 50; ++i) {
    const Refined fine({random_soup(random), straight({-0.3, 0.1, 0}, {0.4, 0.2, 0.1}, 10), 0.3, 0.05});
    const CoarsenBounds bounds{.edge = 0.2, .apart = 0.002};
    const PatchedSurface coarse = fine.coarsened(bounds);
    removed += fine.surface.triangles.size() - coarse.surface.triangles.size();
    ASSERT_EQ(euler_characteristic(coarse.surface), euler_characteristic(fine.surface));
    EXPECT_EQ(coarse.surface.triangles, fine.coarsened(bounds).surface.triangles);
    EXPECT_LE(farthest(fine.surface, coarse.surface), bounds.apart * (1 + 1e-4));
    std::set<std::set<Index>> known;
    for (const Triangle& t : coarse.surface.triangles)
      EXPECT_TRUE(known.emplace(t.begin(), t.end()).second) << "a triangle is there twice";
  }
  EXPECT_GT(removed, 1000u);
}

}  // namespace
}  // namespace burin::test
