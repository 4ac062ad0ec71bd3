// Strokes at random on closed surfaces, judged by CGAL. 20 of them are part of the suite; 200, also on meshes
// of
// ../shared/data/meshes/nasty, are run by
//   level_set_test --gtest_also_run_disabled_tests --gtest_filter='*TwoHundred*'
#include <burin/base/error.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "level_set/ground.h"
#include "support/mesh_fault.h"
#include "support/rods.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin {
namespace {

constexpr double random_rod_radius = 0.06;

/// A sphere with bumps, of edges about 0.035 long.
TriangleMesh bumpy() {
  TriangleMesh mesh = test::sphere(5, 0.2, 4);
  for (Vec3f& p : mesh.positions)
    p *= 1 + 0.03F * std::sin(5 * p.x()) * std::sin(6 * p.y() + 1) * std::cos(4 * p.z());
  return mesh;
}

/// A stroke over a surface that turns at random and may cross itself.
class Wanderer {
 public:
  Wanderer(const TriangleMesh& mesh, std::mt19937& random)
      : surface_(make_surface(mesh)), picker_(surface_), random_(&random) {}

  std::vector<Vec3d> stroke(int samples, double step) {
    Index triangle = 0;
    do triangle = static_cast<Index>((*random_)() % surface_.triangles.size());
    while (normal(triangle).norm() < 0.5);
    Vec3d at = surface_.positions[surface_.triangles[triangle][0]].cast<double>();
    Vec3d way = normal(triangle).unitOrthogonal();
    double turn = 0;
    std::vector<Vec3d> places;
    for (int i = 0; i < samples; ++i) {
      places.push_back(at);
      turn = 0.9 * turn + 0.08 * (share() - 0.5) + 0.02;
      // A triangle without area has no normal.
      if (const Vec3d n = normal(triangle); n.norm() > 0.5) {
        way = (Eigen::AngleAxisd(turn, n) * way).eval();
        way = (way - way.dot(n) * n).stableNormalized();
      }
      const Vec3f ahead = (at + step * way).cast<float>();
      const SurfacePoint next = *picker_.closest(ahead, std::numeric_limits<float>::max());
      at = next.position.cast<double>();
      triangle = next.triangle;
    }
    return places;
  }

 private:
  double share() { return static_cast<double>((*random_)()) / 4294967296.0; }
  Vec3d normal(Index triangle) const {
    const Triangle& t = surface_.triangles[triangle];
    const auto corner = [&](std::size_t i) { return surface_.positions[t[i]].cast<double>().eval(); };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
  }

  Surface surface_;
  Picker picker_;
  std::mt19937* random_;
};

/// What became of many strokes.
struct Tally {
  int merged = 0, refused = 0;
  double least = 180;  ///< angle, degrees

  void print(const char* what) const {
    std::cout << what << ": " << merged << " merged, " << refused << " refused, least angle " << least
              << '\n';
  }
};

/// Lays rods along random strokes, at different heights, half of them to be cut out and a third without a
/// fillet; each on the mesh as it is.
Tally merge_strokes(const TriangleMesh& mesh, int strokes, int samples, bool closed, std::mt19937& random) {
  Wanderer wanderer(mesh, random);
  const bool sound = test::mesh_fault(mesh).empty();
  Tally tally;
  for (int i = 0; i < strokes; ++i) {
    test::Ground ground(mesh, wanderer.stroke(samples, 0.02), closed);
    const double height = 0.03 * static_cast<double>(i % 4) - 0.03;
    ground.lay(test::rod(ground.chart, random_rod_radius, height), height - random_rod_radius,
               height + random_rod_radius, random_rod_radius / 4);
    const SolidOperation operation = i % 2 == 0 ? SolidOperation::unite : SolidOperation::difference;
    try {
      const SurfacePatch patch = ground.merged(operation, i % 3 == 0 ? 0 : 0.02);
      ++tally.merged;
      EXPECT_EQ(sound ? test::mesh_fault(ground.after(patch)) : "", "") << "stroke " << i;
      if (!patch.triangles.empty())
        tally.least = std::min(tally.least, test::angles_of(ground.fresh(patch))[0]);
    } catch (const Error& error) {
      ++tally.refused;
      std::cout << "stroke " << i << ": " << error.what() << '\n';
    }
  }
  return tally;
}

TEST(RandomMerges, AreClosedAndDoNotIntersectThemselves) {
  constexpr std::uint32_t seed = 11;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const Tally tally = merge_strokes(bumpy(), 20, 60, false, random);
  tally.print("bumps");
  EXPECT_GE(tally.merged, 19);
  EXPECT_GE(tally.least, 5);
}

TEST(RandomMerges, DISABLED_TwoHundredStrokes) {
  constexpr std::uint32_t seed = 12;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const Tally open = merge_strokes(bumpy(), 90, 80, false, random),
              closed = merge_strokes(bumpy(), 30, 80, true, random);
  open.print("bumps");
  closed.print("bumps, closed strokes");
  EXPECT_LE(open.refused + closed.refused, 4);
  EXPECT_GE(std::min(open.least, closed.least), 5);
  for (const char* name : {"capsule.obj", "not_convex.obj", "hourglass_ico.obj", "dragon_vrip_res3.ply"}) {
    const auto path = test::shared_data(std::string("meshes/nasty/") + name);
    if (!path) continue;
    merge_strokes(test::fitted(triangulate(read_mesh(*path))), 20, 60, false, random).print(name);
  }
}

}  // namespace
}  // namespace burin
