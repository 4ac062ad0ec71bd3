#include <burin/base/parallel.h>
#include <burin/surface/base_surface/base_surface.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>
#include <vector>

#include "sanitizers/processor_seconds.h"
#include "sanitizers/sanitized.h"
#include "support/shapes.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

std::vector<Index> all_nodes(const BaseSurface& base) {
  std::vector<Index> nodes(base.node_count());
  std::iota(nodes.begin(), nodes.end(), Index{0});
  return nodes;
}

struct Based {
  explicit Based(const TriangleMesh& mesh, double radius)
      : surface(make_surface(mesh)), levels(surface), base(surface, levels) {
    EXPECT_TRUE(base.set_radius(radius));
  }
  Surface surface;
  SurfaceLevels levels;
  BaseSurface base;
};

TEST(BaseSurface, OfASphereIsTheSphere) {
  for (const double radius : {0.12, 0.2, 0.4}) {
    Based on(test::shuffled(test::sphere(6, 0.2, 5), 9), radius);
    for (const Index node : all_nodes(on.base)) {
      const BasePatch& patch = on.base.patch(node);
      ASSERT_NEAR(patch.position.norm(), 1, 0.003 * radius * radius);
      ASSERT_GT(patch.normal.dot(patch.position.normalized()), 1 - 1e-6);
      ASSERT_NEAR(patch.gauss_curvature(), 1, 0.05);
    }
  }
}

TEST(BaseSurface, HasABrushRadiusOfTenToTwentyEdges) {
  for (const double radius : {0.2, 0.3, 0.4, 0.5}) {
    const Based on(test::sphere(6, 0.2, 5), radius);
    EXPECT_GT(radius / on.base.spacing(), 10);
    EXPECT_LT(radius / on.base.spacing(), 24);
  }
}

TEST(BaseSurface, IsNotThereForBrushesNarrowerThanAFewEdges) {
  const Surface surface = make_surface(test::sphere(3, 0.2, 5));
  const SurfaceLevels levels(surface);
  BaseSurface base(surface, levels);
  EXPECT_FALSE(base.set_radius(3 * levels.spacing(0)));
  EXPECT_TRUE(base.set_radius(6 * levels.spacing(0)));
}

/// A square with an egg crate on it whose wavelength is 0.35.
TriangleMesh bumpy(double amplitude) {
  return test::patch({.u_min = -2, .u_max = 2, .v_min = -2, .v_max = 2, .cells_u = 80, .cells_v = 80},
                     [=](double x, double y) {
                       const double k = 2 * std::numbers::pi / 0.35;
                       return Vec3d(x, y, amplitude * std::sin(k * x) * std::sin(k * y));
                     });
}

// The bumps' own slope is 18 times their height.
TEST(BaseSurface, HasNoneOfTheReliefThatIsNarrowAgainstTheBrush) {
  for (const double amplitude : {0.01, 0.05, 0.12}) {
    Based on(bumpy(amplitude), 1);
    double squares = 0, count = 0;
    for (const Index node : all_nodes(on.base)) {
      const BasePatch& patch = on.base.patch(node);
      if (patch.position.head<2>().cwiseAbs().maxCoeff() > 1.2F) continue;
      squares += static_cast<double>(patch.normal.head<2>().squaredNorm());
      ++count;
    }
    ASSERT_GT(count, 100);
    EXPECT_LT(std::sqrt(squares / count), 0.08 * amplitude) << "bumps of " << amplitude;
  }
}

bool same_bits(const BasePatch& a, const BasePatch& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Nodes made one by one from the far end, in one go, and on one thread.
TEST(BaseSurface, DoesNotDependOnTheOrderInWhichNodesAreMade) {
  Based at_once(bumpy(0.05), 1), one_by_one(bumpy(0.05), 1), one_thread(bumpy(0.05), 1);
  at_once.base.prepare(std::array{BaseSurface::Ball{Vec3f::Zero(), 100, 0}});
  for (Index node = one_by_one.base.node_count(); node-- > 0;) one_by_one.base.patch(node);
  const ThreadLimit limit(1);
  one_thread.base.prepare(std::array{BaseSurface::Ball{Vec3f::Zero(), 100, 0}});
  for (const Index node : all_nodes(at_once.base)) {
    ASSERT_TRUE(same_bits(at_once.base.patch(node), one_by_one.base.patch(node)));
    ASSERT_TRUE(same_bits(at_once.base.patch(node), one_thread.base.patch(node)));
  }
}

// Kept nodes and new ones are those of a base surface that is made afresh.
TEST(BaseSurface, FollowsVerticesThatMove) {
  Based on(test::shuffled(test::sphere(6, 0.2, 5), 9), 0.2);
  on.base.prepare(std::array{BaseSurface::Ball{Vec3f::Zero(), 2, 0}});
  std::vector<Index> moved;
  for (Index vertex = 0; vertex < on.surface.vertex_count(); ++vertex)
    if (on.surface.positions[vertex].x() > 0.95F) moved.push_back(vertex);
  ASSERT_GT(moved.size(), 100U);
  for (const Index vertex : moved) on.surface.positions[vertex] *= 1.1F;
  on.levels.moved(moved);
  on.base.forget(moved, 0.1);
  const SurfaceLevels levels_now(on.surface);
  BaseSurface fresh(on.surface, on.levels);
  ASSERT_TRUE(fresh.set_radius(0.2));
  std::size_t changed = 0;
  for (const Index node : all_nodes(fresh)) {
    ASSERT_TRUE(same_bits(on.base.patch(node), fresh.patch(node))) << "node " << node;
    changed += fresh.patch(node).position.norm() > 1.01F;
  }
  EXPECT_GT(changed, 10U);
}

/// A slab of this thickness, open at all narrow sides but one.
TriangleMesh plate(double thickness) {
  const double length = 2, around = 2 * length + thickness;
  return test::patch({.u_min = 0, .u_max = around, .v_min = -1, .v_max = 1, .cells_u = 160, .cells_v = 80},
                     [=](double u, double v) {
                       if (u < length) return Vec3d(length - u, -v, thickness / 2);
                       if (u < length + thickness) return Vec3d(0, -v, thickness / 2 - (u - length));
                       return Vec3d(u - length - thickness, -v, -thickness / 2);
                     });
}

// A brush wider than the plate is thick feels the side that it is on.
TEST(BaseSurface, KeepsTheSidesOfAPlateApart) {
  Based on(plate(0.1), 0.6);
  for (const Index node : all_nodes(on.base)) {
    const Vec3f& position = on.base.patch(node).position;
    if (position.x() < 0.5F) continue;  // near the rim that joins them
    const float side = position.z() > 0 ? 1.F : -1.F;
    ASSERT_NEAR(position.z(), side * 0.05F, 0.002F);
    ASSERT_GT(on.base.patch(node).normal.z() * side, 0.99F);
  }
}

// Without stand-ins every vertex of the rim would fit thousands of others: half a minute of processor time.
TEST(BaseSurface, CostsAFanInProportionToItsSpokes) {
  Based on(test::fan(80000), 0.55);
  const double seconds = test::processor_seconds([&] {
    on.base.prepare(std::array{BaseSurface::Ball{Vec3f::UnitX(), 3, 1}});
  });
  if (!test::sanitized) {
    EXPECT_LT(seconds, 6);
  }
  for (Index node = 0; node < on.base.node_count(); node += 97) {
    const BasePatch& patch = on.base.patch(node);
    ASSERT_NEAR(patch.position.z(), 0, 1e-6);
    ASSERT_GT(patch.normal.z(), 0.9999F);
  }
}

TEST(BaseSurface, IsNotForBrushesThatAreNarrowerThanMostTriangles) {
  const Surface surface = make_surface(test::fan(300));
  const SurfaceLevels levels(surface);
  BaseSurface base(surface, levels);
  EXPECT_FALSE(base.set_radius(0.45));
  EXPECT_TRUE(base.set_radius(0.55));
}

TEST(BaseSurface, ProjectsPointsOntoASphere) {
  Based on(test::shuffled(test::sphere(6, 0.2, 5), 9), 0.3);
  for (const Vec3f& direction : {Vec3f(1, 2, 3), Vec3f(-3, 1, 0.2F), Vec3f(0, 0, 1)}) {
    for (const float height : {0.95F, 1.F, 1.08F}) {
      const Vec3f unit = direction.normalized();
      const BasePoint at = on.base.project(0, height * unit);
      EXPECT_LT((at.position - unit).norm(), 2e-3) << height;
      EXPECT_LT((at.normal - unit).norm(), 5e-3) << height;
    }
  }
}

}  // namespace
}  // namespace burin
