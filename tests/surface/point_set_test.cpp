#include <burin/base/error.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/picker.h>
#include <burin/surface/point_set.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/point_shapes.h"

namespace burin {
namespace {

bool linked(const Surface& surface, Index a, Index b) {
  return std::ranges::binary_search(surface.neighbours[a], b);
}

TEST(PointSet, KeepsPointsAndNormalsAndJoinsBothWays) {
  const PointSet points = test::sphere_points(4, 3);
  const Surface surface = make_point_surface(points, 8);
  ASSERT_EQ(surface.vertex_count(), points.positions.size());
  EXPECT_TRUE(surface.is_point_set());
  EXPECT_NEAR(surface.scale, 2 * std::sqrt(3), 0.05);
  std::vector<Index> source = surface.source_vertex;
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    ASSERT_EQ(surface.positions[v], points.positions[source[v]]);
    ASSERT_LT((surface.normals[v] - points.normals[source[v]].normalized()).norm(), 1e-6F);
    ASSERT_TRUE(surface.incident[v].empty());
    ASSERT_GE(surface.neighbours[v].size(), 8U);
    const auto ascending = std::ranges::adjacent_find(surface.neighbours[v], std::greater_equal());
    ASSERT_EQ(ascending, surface.neighbours[v].end());
    for (const Index other : surface.neighbours[v]) {
      ASSERT_NE(other, v);
      ASSERT_TRUE(linked(surface, other, v));
    }
  }
  std::ranges::sort(source);
  for (Index v = 0; v < source.size(); ++v) ASSERT_EQ(source[v], v);
}

/// The links that brute force finds: the nearest in either direction.
TEST(PointSet, JoinsTheNearest) {
  const Surface surface = make_point_surface(test::plane_points(1, 0.1, 5), 6);
  const auto nearest = [&](Index v) {
    std::vector<Index> others;
    for (Index w = 0; w < surface.vertex_count(); ++w) {
      if (w != v) others.push_back(w);
    }
    std::ranges::sort(others, {}, [&](Index w) {
      return (surface.positions[w] - surface.positions[v]).cast<double>().squaredNorm();
    });
    others.resize(6);
    return others;
  };
  std::vector<std::vector<Index>> expected(surface.vertex_count());
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    for (const Index w : nearest(v)) {
      expected[v].push_back(w);
      expected[w].push_back(v);
    }
  }
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    std::ranges::sort(expected[v]);
    expected[v].erase(std::unique(expected[v].begin(), expected[v].end()), expected[v].end());
    ASSERT_TRUE(std::ranges::equal(surface.neighbours[v], expected[v])) << v;
  }
}

// A plate thinner than its points' distance.
TEST(PointSet, DoesNotJoinTheSidesOfAThinPart) {
  PointSet plate = test::plane_points(1, 0.1, 5), back = test::plane_points(1, 0.1, 15);
  for (Vec3f& x : back.positions) x.z() = -0.02F;
  for (Vec3f& n : back.normals) n = -n;
  plate.positions.insert(plate.positions.end(), back.positions.begin(), back.positions.end());
  plate.normals.insert(plate.normals.end(), back.normals.begin(), back.normals.end());
  const Surface surface = make_point_surface(plate, 8);
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    EXPECT_GE(surface.neighbours[v].size(), 8U);
    for (const Index other : surface.neighbours[v]) {
      ASSERT_EQ(surface.positions[v].z() < -0.01F, surface.positions[other].z() < -0.01F);
    }
  }
  const Picker picker(surface);
  EXPECT_NEAR(picker.closest({0.1F, 0.1F, 0.05F}, 1)->position.z(), 0, 1e-6);
  EXPECT_NEAR(picker.closest({0.1F, 0.1F, -0.07F}, 1)->position.z(), -0.02, 1e-6);
}

TEST(PointSet, DoesNotDependOnTheOrderOfTheInput) {
  const auto sphere = [](std::uint32_t seed) {
    return make_point_surface(
        test::points_of(test::shuffled(test::sphere(4, 0.2, 1), seed), [](const Vec3f& x) { return x; }));
  };
  const Surface a = sphere(2), b = sphere(3);
  EXPECT_NE(a.source_vertex, b.source_vertex);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.neighbours.offsets, b.neighbours.offsets);
  EXPECT_EQ(a.neighbours.items, b.neighbours.items);
}

void expect_refused(const PointSet& points, const std::string& message) {
  try {
    make_point_surface(points);
    ADD_FAILURE() << "accepted; expected " << message;
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), message);
  }
}

TEST(PointSet, RefusesWhatIsNone) {
  const PointSet good = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  EXPECT_EQ(make_point_surface(good).vertex_count(), 3U);
  PointSet bad = good;
  bad.positions[1].y() = NAN;
  expect_refused(bad, "point 2 has a coordinate that is not finite");
  bad = good;
  bad.normals[2].x() = INFINITY;
  expect_refused(bad, "the normal of point 3 is not finite or zero");
  bad = good;
  bad.normals[0].setZero();
  expect_refused(bad, "the normal of point 1 is not finite or zero");
  expect_refused({}, "a point set needs 3 points at least");
  EXPECT_THROW(make_point_surface(good, 2), ContractError);
  bad = good;
  bad.normals.pop_back();
  EXPECT_THROW(make_point_surface(bad), ContractError);
}

void expect_between_corners(const Surface& surface, const SurfacePoint& point, double slack) {
  Vec3f blend = Vec3f::Zero();
  float sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GE(point.weights[i], 0);
    blend += point.weights[i] * surface.positions[point.corners[i]];
    sum += point.weights[i];
  }
  EXPECT_EQ(point.triangle, no_index);
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_LT((blend - point.position).norm(), slack);
}

TEST(PointPicker, FindsTheFootOnAPlaneAndTheNearestPointBeyondItsBorder) {
  const Surface surface = make_point_surface(test::plane_points(1, 0.05, 5));
  const Picker picker(surface);
  const auto foot = picker.closest({0.212F, -0.333F, 0.2F}, 1);
  ASSERT_TRUE(foot);
  EXPECT_LT((foot->position - Vec3f(0.212F, -0.333F, 0)).norm(), 1e-6F);
  expect_between_corners(surface, *foot, 1e-6);
  EXPECT_FALSE(picker.closest({0.212F, -0.333F, 0.2F}, 0.19F));
  EXPECT_FALSE(picker.closest({NAN, 0, 0}, 1));

  const auto beyond = picker.closest({1.5F, 0.1F, 0}, 1);
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->position, surface.positions[beyond->corners[0]]);
  EXPECT_NEAR(beyond->position.x(), 1, 1e-6);
  expect_between_corners(surface, *beyond, 1e-6);
}

TEST(PointPicker, FindsTheFootOnASphere) {
  const unsigned seed = 77;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  const Surface surface = make_point_surface(test::sphere_points(5, 9));
  const Picker picker(surface);
  double off_surface = 0, aside = 0, normal = 0;
  for (int i = 0; i < 1000; ++i) {
    const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
    const Vec3f direction = Vec3f(x, y, z).normalized();
    const float height = 0.2F * coordinate(random);
    const auto foot = picker.closest((1 + height) * direction, 1);
    ASSERT_TRUE(foot);
    off_surface = std::max(off_surface, std::abs(foot->position.cast<double>().norm() - 1));
    aside = std::max(aside,
                     static_cast<double>((foot->position - direction).norm() / (1e-3F + std::abs(height))));
    const Vec3f outward = foot->position.normalized();
    normal = std::max(normal, static_cast<double>((normal_at(surface, *foot) - outward).norm()));
    expect_between_corners(surface, *foot, 2e-3);
  }
  std::cout << "off the surface by at most " << off_surface << ", aside by " << aside
            << " of the height, normal off by " << normal << "\n";
  EXPECT_LT(off_surface, 1e-4);
  EXPECT_LT(aside, 0.02);
  EXPECT_LT(normal, 1e-3);
}

TEST(PointPicker, MeetsRaysWhereTheSphereDoes) {
  const unsigned seed = 78;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Surface surface = make_point_surface(test::sphere_points(5, 9));
  const Picker picker(surface);
  int hits = 0, misses = 0, inside = 0;
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const double size = i % 4 == 0 ? 0.5 : 3;  // now and then from inside
    const Vec3d from(size * coordinate(random), size * coordinate(random), size * coordinate(random));
    const Vec3d aim(coordinate(random), coordinate(random), coordinate(random));
    const Vec3d along = (aim - from).normalized();
    const double middle = -from.dot(along), squared = middle * middle - from.squaredNorm() + 1;
    // Rays that graze the surface or begin on it are not judged.
    if (std::abs(squared) < 0.02 || std::abs(from.norm() - 1) < 0.05) continue;
    const double root = squared > 0 ? std::sqrt(squared) : 0;
    const double distance = middle - root > 0 ? middle - root : middle + root;
    const bool expected = squared > 0 && distance > 0;
    const auto hit = picker.pick({from.cast<float>(), (2 * along).cast<float>()});
    ASSERT_EQ(hit.has_value(), expected) << "ray " << i;
    ++(expected ? hits : misses);
    inside += from.norm() < 1;
    if (!hit) continue;
    worst = std::max(worst, (hit->position.cast<double>() - (from + distance * along)).norm());
  }
  std::cout << "hit off by at most " << worst << "\n";
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 50);
  EXPECT_GT(inside, 200);
}

TEST(PointPicker, EndsAtTheBorder) {
  const Surface surface = make_point_surface(test::plane_points(1, 0.05, 5));
  const Picker picker(surface);
  EXPECT_TRUE(picker.pick({{0.97F, 0, 1}, {0, 0, -1}}));
  EXPECT_TRUE(picker.pick({{0.97F, 0, -1}, {0, 0, 1}}));
  EXPECT_FALSE(picker.pick({{1.01F, 0, 1}, {0, 0, -1}}));
  EXPECT_FALSE(picker.pick({{0, 0, 1}, {0, 0, 1}}));
}

TEST(PointPicker, StandsPointsInOnePlaceAndOnALine) {
  PointSet heap;
  for (int i = 0; i < 40; ++i) heap.positions.emplace_back(1, 2, 3);
  for (int i = 0; i < 20; ++i) heap.positions.emplace_back(static_cast<float>(i), 0, 0);
  heap.normals.assign(heap.positions.size(), Vec3f::UnitZ());
  const Surface surface = make_point_surface(heap);
  const Picker picker(surface);
  for (const Vec3f& query : {Vec3f(1, 2, 3.5F), Vec3f(1.2F, 1.9F, 3), Vec3f(3.3F, 0.4F, 0.1F)}) {
    const auto found = picker.closest(query, 10);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->position.allFinite());
    EXPECT_TRUE(normal_at(surface, *found).allFinite());
    picker.pick({query, {0, 0, -1}});
  }
}

TEST(PointPicker, FollowsNoMovedPoints) {
  const Surface surface = make_point_surface(test::plane_points(1, 0.2, 5));
  const Index moved[] = {0};
  EXPECT_THROW(Picker(surface).update(moved), ContractError);
}

TEST(PointPicker, MissesWithRaysThatAreNone) {
  const Surface surface = make_point_surface(test::sphere_points(3, 1));
  const Picker picker(surface);
  constexpr float infinity = std::numeric_limits<float>::infinity(),
                  nan = std::numeric_limits<float>::quiet_NaN();
  const float numbers[] = {0,     1,      -1,    1e-30F,   1e-45F,    1e10F, 1e18F,
                           1e19F, -1e30F, 3e38F, infinity, -infinity, nan};
  for (const float a : numbers)
    for (const float b : numbers)
      for (const float c : numbers)
        for (const Vec3f& direction : {Vec3f(a, b, c), Vec3f(0, 0, c), Vec3f(c, 0, 1)}) {
          const auto hit = picker.pick({{b, 0, a}, direction});
          EXPECT_TRUE(!hit || hit->position.allFinite());
          EXPECT_TRUE(!picker.closest(direction, infinity) ||
                      picker.closest(direction, infinity)->position.allFinite());
        }
}

}  // namespace
}  // namespace burin
