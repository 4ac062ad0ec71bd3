#include <burin/surface/picker.h>
#include <burin/surface/picking/closest_point.h>
#include <burin/surface/picking/pick_scene.h>
#include <burin/surface/picking/ray_triangle.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "sanitizers/processor_seconds.h"
#include "sanitizers/sanitized.h"
#include "support/shapes.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

constexpr unsigned seed = 20130721;
constexpr float unlimited = std::numeric_limits<float>::infinity();

class Random {
 public:
  Vec3f point(float half_width) {
    std::uniform_real_distribution<float> coordinate(-half_width, half_width);
    const float x = coordinate(generator_), y = coordinate(generator_), z = coordinate(generator_);
    return {x, y, z};
  }

 private:
  std::mt19937 generator_{seed};
};

std::array<Vec3d, 3> corners(const Surface& surface, Index triangle) {
  const auto corner = [&](int i) -> Vec3d {
    return surface.positions[surface.triangles[triangle][i]].cast<double>();
  };
  return {corner(0), corner(1), corner(2)};
}

/// Moller and Trumbore 1997, in doubles: distance along the ray, or infinity.
double ray_distance(const Surface& surface, Index triangle, const Ray& ray) {
  const auto [a, b, c] = corners(surface, triangle);
  const Vec3d direction = ray.direction.cast<double>(), to_origin = ray.origin.cast<double>() - a;
  const Vec3d p = direction.cross(c - a), q = to_origin.cross(b - a);
  const double determinant = (b - a).dot(p);
  const double u = to_origin.dot(p) / determinant, v = direction.dot(q) / determinant;
  const double distance = (c - a).dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && distance >= 0 ? distance : std::numeric_limits<double>::infinity();
}

Vec3d closest_on_segment(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  return a + std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) * (b - a);
}

/// The foot in the triangle's plane where it lies inside, else the nearest point of the three edges.
Vec3d closest_on_triangle(const std::array<Vec3d, 3>& t, const Vec3d& p) {
  const auto& [a, b, c] = t;
  const Vec3d normal = (b - a).cross(c - a).normalized();
  const Vec3d foot = p - (p - a).dot(normal) * normal;
  const auto left_of = [&](const Vec3d& from, const Vec3d& to) {
    return (to - from).cross(foot - from).dot(normal) >= 0;
  };
  if (left_of(a, b) && left_of(b, c) && left_of(c, a)) return foot;
  return std::min({closest_on_segment(a, b, p), closest_on_segment(b, c, p), closest_on_segment(c, a, p)},
                  [&](const Vec3d& x, const Vec3d& y) { return (x - p).norm() < (y - p).norm(); });
}

/// Least of value(triangle) over all triangles.
template <class Value>
double least(const Surface& surface, const Value& value) {
  double result = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < surface.triangles.size(); ++i) result = std::min(result, value(i));
  return result;
}

Vec3d at_barycentrics(const Surface& surface, const SurfacePoint& point) {
  EXPECT_EQ(point.corners, surface.triangles[point.triangle]);
  const auto [a, b, c] = corners(surface, point.triangle);
  return double{point.weights[0]} * a + double{point.weights[1]} * b + double{point.weights[2]} * c;
}

/// More triangles than four levels of the picker's tree hold.
const Surface& ring() {
  static const Surface surface = make_surface(test::torus(160, 80));
  return surface;
}

TEST(Picker, HitsWhatBruteForceHits) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Picker picker(ring());
  Random random;
  int hits = 0, misses = 0;
  for (int i = 0; i < 400; ++i) {
    const Ray ray{random.point(3), random.point(1) * 2};
    const double expected = least(ring(), [&](Index t) { return ray_distance(ring(), t, ray); });
    const auto hit = picker.pick(ray);
    ASSERT_EQ(hit.has_value(), std::isfinite(expected)) << "ray " << i;
    ++(hit ? hits : misses);
    if (!hit) continue;
    EXPECT_LT((hit->position - (ray.origin + static_cast<float>(expected) * ray.direction)).norm(), 1e-5f);
    EXPECT_LT((hit->position.cast<double>() - at_barycentrics(ring(), *hit)).norm(), 1e-6);
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(misses, 50);
}

// Rays through corners and edges of a grid along its axes: the components of -0 must not move them aside.
TEST(Picker, HitsFlatGridsAtTheirCornersAndEdges) {
  const Surface surface = make_surface(
      test::patch({.u_min = -1, .u_max = 1, .v_min = -1, .v_max = 1, .cells_u = 100, .cells_v = 100},
                  [](double u, double v) { return Vec3d(u, v, 0); }));
  const Picker picker(surface);
  for (const float zero : {0.F, -0.F})
    for (const Vec3f& corner : surface.positions) {
      if (corner.cwiseAbs().maxCoeff() > 0.99F) continue;
      EXPECT_TRUE(picker.pick({corner + Vec3f(0, 0, 1), {zero, zero, -1}})) << corner.transpose();
      EXPECT_TRUE(picker.pick({corner + Vec3f(0.005F, 0, 1), {zero, zero, -1}})) << corner.transpose();
    }
}

TEST(Picker, HitsFromBothSides) {
  const Surface surface = make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Picker picker(surface);
  EXPECT_TRUE(picker.pick({{0.2f, 0.2f, 1}, {0, 0, -1}}));
  EXPECT_TRUE(picker.pick({{0.2f, 0.2f, -1}, {0, 0, 5}}));
  EXPECT_FALSE(picker.pick({{0.2f, 0.2f, 1}, {0, 0, 1}}));
}

TEST(Picker, FindsTheClosestPointThatBruteForceFinds) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Picker picker(ring());
  Random random;
  int within = 0, beyond = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3f query = random.point(3);
    const double expected = least(ring(), [&](Index t) {
      return (closest_on_triangle(corners(ring(), t), query.cast<double>()) - query.cast<double>()).norm();
    });
    const auto found = picker.closest(query, unlimited);
    ASSERT_TRUE(found);
    EXPECT_NEAR((found->position - query).norm(), expected, 1e-5);
    EXPECT_LT((found->position.cast<double>() - at_barycentrics(ring(), *found)).norm(), 1e-6);
    const auto near = picker.closest(query, 0.5f);
    EXPECT_EQ(near.has_value(), expected <= 0.5);
    ++(near ? within : beyond);
  }
  EXPECT_GT(within, 50);
  EXPECT_GT(beyond, 50);
}

TEST(Picker, FindsNothingWhereThereIsNothing) {
  Surface surface;
  const std::unique_ptr<PickScene> scene = make_triangle_scene(surface);
  EXPECT_FALSE(scene->pick({{0, 0, 1}, {0, 0, -1}}));
  EXPECT_FALSE(scene->closest(Vec3f::Zero(), unlimited));
  EXPECT_TRUE(scene->near(Vec3f::Zero(), 1, 9)->empty());
}

TEST(Picker, ListsTrianglesWithinADistance) {
  const Surface surface = make_surface(test::sphere(4, 0.3, 5));
  const Picker picker(surface);
  Random random;
  std::size_t listed = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3f query = random.point(1.5F);
    const float reach = 0.1F + 0.01F * static_cast<float>(i);
    const auto near = picker.near(query, reach, surface.triangles.size());
    ASSERT_TRUE(near);
    std::set<Index> numbers(near->begin(), near->end());
    ASSERT_EQ(numbers.size(), near->size());
    for (Index triangle = 0; triangle < surface.triangles.size(); ++triangle)
      if (closest_point(surface, triangle, query.cast<double>()).squared_distance <= reach * reach)
        ASSERT_TRUE(numbers.contains(triangle)) << "seed " << seed << ", query " << i;
    listed += near->size();
    if (!near->empty()) EXPECT_FALSE(picker.near(query, reach, near->size() - 1));
  }
  EXPECT_GT(listed, 1000U);
  EXPECT_LT(listed, 100 * surface.triangles.size() / 2);
}

TEST(Picker, PrefersTheLowestOfEquallyNearTriangles) {
  const Surface surface = make_surface(test::torus(40, 20));
  const Picker picker(surface);
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    const auto found = picker.closest(surface.positions[vertex], 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->triangle, surface.incident[vertex].front());
    EXPECT_EQ(found->position, surface.positions[vertex]);
  }
}

TEST(Picker, OfTrianglesInOnePlaceHitsTheLowest) {
  TriangleMesh mesh = test::torus(40, 20);
  const std::vector<Triangle> once = mesh.triangles;
  for (int copy = 0; copy < 8; ++copy) mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
  const Surface surface = make_surface(mesh);
  const Picker picker(surface);
  Random random;
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const auto hit = picker.pick({random.point(3), random.point(1)});
    if (!hit) continue;
    ++hits;
    const auto lowest = std::ranges::find(surface.triangles, surface.triangles[hit->triangle]);
    EXPECT_EQ(hit->triangle, lowest - surface.triangles.begin());
  }
  EXPECT_GT(hits, 50);
}

/// The lowest of the triangles that a ray meets first, its distance rounded to a float.
Index first_met(const Surface& surface, const Ray& ray) {
  const TriangleRay to(ray);
  Index first = no_index;
  float nearest = unlimited;
  for (Index triangle = 0; triangle < surface.triangles.size(); ++triangle) {
    const auto hit = to.meet(surface, triangle);
    if (!hit || !(static_cast<float>(hit->distance) < nearest)) continue;
    nearest = static_cast<float>(hit->distance);
    first = triangle;
  }
  return first;
}

// Rays at vertices and along coordinate planes run along the sides of many boxes; from afar they are coarse.
TEST(Picker, OverlooksNoTriangleBehindTheSideOfABox) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Surface surface = make_surface(test::torus(40, 20));
  const Picker picker(surface);
  Random random;
  int hits = 0;
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    for (const Vec3f& way : {random.point(1), Vec3f(1, 0, 0), Vec3f(0, -1, 0), Vec3f(1e-30f, 0, 1)})
      for (const float afar : {0.0f, 1.0f, 1e4f}) {
        const Ray ray{surface.positions[vertex] - afar * way, way};
        const Index expected = first_met(surface, ray);
        const auto hit = picker.pick(ray);
        ASSERT_EQ(hit ? hit->triangle : no_index, expected) << "vertex " << vertex << ", from " << afar;
        hits += hit.has_value();
      }
  EXPECT_GT(hits, 5000);
}

TEST(Picker, FindsEveryTriangleOfAnyNumberOfThem) {
  for (const Index columns : {3u, 4u, 5u, 11u, 12u, 31u, 32u, 33u, 85u, 86u}) {
    TriangleMesh mesh = test::torus(3, columns);
    mesh.triangles.resize(mesh.triangles.size() - columns % 2);
    const Surface surface = make_surface(mesh);
    const Picker picker(surface);
    for (Index triangle = 0; triangle < surface.triangles.size(); ++triangle) {
      Vec3f centre = Vec3f::Zero();
      for (const Index corner : surface.triangles[triangle]) centre += surface.positions[corner] / 3;
      EXPECT_EQ(picker.closest(centre, unlimited)->triangle, triangle) << surface.triangles.size();
    }
  }
}

TEST(Picker, ClosestPointOfATriangleWithoutAreaIsOnItsEdges) {
  Random random;
  for (int i = 0; i < 300; ++i) {
    const Vec3f along = random.point(1), from = along / 2, query = random.point(2);
    // Corners and their differences are exact, so the second triangle, far away, has the only area.
    const Surface surface = make_surface(
        {{from, 2 * from, 4 * from, {0, 90, 0}, {1, 90, 0}, {0, 90, 1}}, {{0, 1, 2}, {3, 4, 5}}});
    const auto found = Picker(surface).closest(query, unlimited);
    ASSERT_TRUE(found);
    const Vec3d expected =
        closest_on_segment(from.cast<double>(), 4 * from.cast<double>(), query.cast<double>());
    EXPECT_LT((found->position.cast<double>() - expected).norm(), 1e-6);
  }
}

/// A picker that followed moved vertices answers like a new one, bit for bit.
void expect_follows(Surface surface) {
  Picker picker(surface);
  std::vector<Index> moved(500);
  std::iota(moved.begin(), moved.end(), surface.vertex_count() / 2);
  moved.push_back(surface.vertex_count() - 1);
  for (const Index vertex : moved) surface.positions[vertex] += 0.3f * surface.normals[vertex];
  picker.update(moved);
  const Picker fresh(surface);
  Random random;
  int on_moved = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3f from = random.point(3);
    const auto followed = picker.closest(from, unlimited), expected = fresh.closest(from, unlimited);
    ASSERT_EQ(followed->triangle, expected->triangle);
    ASSERT_EQ(followed->position, expected->position);
    on_moved += std::ranges::any_of(surface.triangles[expected->triangle],
                                    [&](Index v) { return std::ranges::find(moved, v) != moved.end(); });
    const Ray ray{from, random.point(1)};
    const auto hit = picker.pick(ray), expected_hit = fresh.pick(ray);
    ASSERT_EQ(hit.has_value(), expected_hit.has_value());
    ASSERT_EQ(hit ? hit->position : from, expected_hit ? expected_hit->position : from);
  }
  EXPECT_GT(on_moved, 30);
}

TEST(Picker, FollowsMovedVertices) {
  expect_follows(make_surface(test::torus(160, 80)));
  expect_follows(make_surface(test::fan(3000)));
}

/// A fan whose rim rises and falls, so that no two of its triangles have a plane in common.
Surface wavy_fan(Index spokes) {
  TriangleMesh mesh = test::fan(spokes);
  for (Vec3f& position : mesh.positions) position.z() = position.x() * position.y() / 4;
  return make_surface(mesh);
}

// The boxes of long thin triangles hold much more than they do, so slabs rule triangles out, too.
TEST(Picker, FindsTheClosestOfLongThinTriangles) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Surface surface = wavy_fan(5000);
  const Picker picker(surface);
  Random random;
  const auto expect_lowest = [&](const Vec3f& query) {
    const auto squared_distance = [&](Index triangle) {
      return closest_point(surface, triangle, query.cast<double>()).squared_distance;
    };
    const double expected = least(surface, squared_distance);
    Index lowest = 0;
    while (squared_distance(lowest) > expected) ++lowest;
    EXPECT_EQ(picker.closest(query, unlimited)->triangle, lowest) << query.transpose();
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3f place = random.point(1);
    expect_lowest(place);
    expect_lowest({place.x() / 2, place.y() / 2, place.x() * place.y() / 16});
    expect_lowest(surface.positions[static_cast<Index>(i) * 25]);
  }
}

// Of 100,000 spokes the boxes of some 12,000 hold a position: 5000 searches of them took 4 s.
TEST(Picker, SearchesAFanOfManySpokesInNoTime) {
  const Surface surface = make_surface(test::fan(100000));
  const Picker picker(surface);
  Random random;
  const double seconds = test::processor_seconds([&] {
    for (int i = 0; i < 5000; ++i) {
      const Vec3f place = random.point(0.7F);
      const Vec3f flat(place.x(), place.y(), 0);
      ASSERT_LT((picker.closest(flat, 1)->position - flat).norm(), 1e-6F);
    }
  });
  if (!test::sanitized) {
    EXPECT_LT(seconds, 1);
  }
}

}  // namespace
}  // namespace burin
