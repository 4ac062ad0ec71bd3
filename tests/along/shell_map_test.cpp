// The places of (t, d, h) on surfaces where they are known.
#include <burin/along/shell_map.h>
#include <burin/base/error.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>

#include "along/bent.h"
#include "support/drawn_strokes.h"
#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;
using test::Laid;

constexpr double shell_radius = 0.2;

/// A stroke whose coordinates are known: the surface by its edges, and the place of (t, d, h).
struct Known {
  const char* name;
  std::function<TriangleMesh(double edge)> mesh;
  std::function<Vec3d(double share)> stroke;
  bool closed;
  std::function<Vec3d(double t, double d, double h)> place;
};

Known straight_on_plane() {
  const Vec3d from(-0.5, -0.1, 0), along = Vec3d(1, 0.22, 0).normalized(), left(-along.y(), along.x(), 0);
  return {"plane", [](double edge) { return test::plane(1, edge, 7); },
          [=](double s) { return Vec3d(from + s * along); }, false,
          [=](double t, double d, double h) { return Vec3d(from + t * along + d * left + Vec3d(0, 0, h)); }};
}

Known circle_on_plane() {
  return {"circle_on_plane", [](double edge) { return test::plane(1, edge, 7); },
          [](double s) { return Vec3d(0.5 * std::cos(2 * pi * s), 0.5 * std::sin(2 * pi * s), 0); }, true,
          [](double t, double d, double h) {
            return Vec3d((0.5 - d) * std::cos(2 * t), (0.5 - d) * std::sin(2 * t), h);
          }};
}

/// At 30 degrees to the rulings, from the cylinder's unrolled plane.
Known helix_on_cylinder() {
  const Vec2d along(0.5, std::sqrt(0.75)), left(-along.y(), along.x());
  const auto up = [](double arc) { return Vec3d(std::cos(2 * arc), std::sin(2 * arc), 0); };
  return {"helix_on_cylinder", [](double edge) { return test::cylinder(0.5, 1, edge, 0.2, 5); },
          [=](double s) {
            const Vec2d at = (s - 0.5) * along;
            return Vec3d(0.5 * up(at.x()) + Vec3d(0, 0, at.y()));
          },
          false,
          [=](double t, double d, double h) {
            const Vec2d at = (t - 0.5) * along + d * left;
            return Vec3d((0.5 + h) * up(at.x()) + Vec3d(0, 0, at.y()));
          }};
}

Known great_circle() {
  return {
      "great_circle",
      [](double edge) { return test::sphere(static_cast<int>(std::lround(std::log2(1.1 / edge))), 0.2, 4); },
      [](double s) { return Vec3d(std::cos(2 * pi * s), std::sin(2 * pi * s), 0); }, true,
      [](double t, double d, double h) {
        return Vec3d((1 + h) * Vec3d(std::cos(d) * std::cos(t), std::cos(d) * std::sin(t), std::sin(d)));
      }};
}

/// Straight in the cone's unrolled plane.
Known straight_on_cone() {
  static const auto cone = test::exact_cone();
  const Vec2d from(-0.3, -0.35), along = Vec2d(0.6, 0.8), left(-0.8, 0.6);
  return {"cone", [](double edge) { return cone->mesh(edge, 1, 3); },
          [=](double s) { return cone->place(from + s * along); }, false,
          [=](double t, double d, double h) {
            const Vec3d at = cone->place(from + t * along + d * left);
            const Vec3d outward(at.x(), at.y(), 0);
            // The sides are at 30 degrees to the axis.
            const Vec3d normal = std::sqrt(0.75) * outward.normalized() + Vec3d(0, 0, 0.5);
            return Vec3d(at + h * normal);
          }};
}

class ShellMapOf : public testing::TestWithParam<Known> {};

INSTANTIATE_TEST_SUITE_P(Strokes, ShellMapOf,
                         testing::Values(straight_on_plane(), circle_on_plane(), helix_on_cylinder(),
                                         great_circle(), straight_on_cone()),
                         [](const auto& known) { return std::string(known.param.name); });

struct Errors {
  double mean = 0, most = 0;
};

Errors errors_of(const Known& known, double edge) {
  const Laid laid(known.mesh(edge), shell_radius, test::sampled(200, known.stroke), known.closed);
  const ShellMap map(laid.ground());
  Errors errors;
  int count = 0;
  for (double t = 0.02; t < laid.chart.length - 0.02; t += 0.017)
    for (double d = -0.95 * shell_radius; d < shell_radius; d += 0.11 * shell_radius)
      for (const double h : {-0.1, 0., 0.15}) {
        const double error = (map(t, d, h) - known.place(t, d, h)).norm();
        errors.mean += error;
        errors.most = std::max(errors.most, error);
        ++count;
      }
  errors.mean /= count;
  return errors;
}

TEST_P(ShellMapOf, IsRightToSecondOrder) {
  const Known& known = GetParam();
  const Errors coarse = errors_of(known, 0.04), fine = errors_of(known, 0.02);
  std::cout << fmt::format("{}: mean {:.2e} and {:.2e}, most {:.2e} and {:.2e}\n", known.name, coarse.mean,
                           fine.mean, coarse.most, fine.most);
  EXPECT_LT(fine.mean, 2e-4);
  EXPECT_LT(fine.most, 1.5e-3);
  // On a plane only the curve itself is not exact.
  if (fine.mean > 2e-5) {
    EXPECT_GT(coarse.mean / fine.mean, 2.8);
  }
}

// Around a circle narrower than the stroke lines of constant t meet in its middle.
TEST(ShellMap, EndsAtTheFocalPointOfABend) {
  constexpr double narrow = 0.1, edge = 0.02;
  const Laid laid(
      test::plane(0.6, edge, 7), shell_radius,
      test::sampled(
          200,
          [](double s) { return Vec3d(narrow * std::cos(2 * pi * s), narrow * std::sin(2 * pi * s), 0); }),
      true);
  const ShellMap map(laid.ground());
  for (double t = 0; t < laid.chart.length; t += 0.01) {
    const double angle = t / narrow;
    for (double d = -0.2; d <= 0.2; d += 0.02) {
      const double from_middle = std::max(narrow - d, 0.);
      const Vec3d known(from_middle * std::cos(angle), from_middle * std::sin(angle), 0.05);
      // The nearer to the middle, the coarser are angles in edges.
      const double edges = d > 0.07 ? 2 : d > 0.05 ? 0.4 : 0.2;
      EXPECT_LT((map(t, d, 0.05) - known).norm(), edges * edge) << t << ' ' << d;
    }
  }
}

// Two legs at right angles. Near the corner points beyond the line on which the legs are as near stay on it.
// Farther away the chart may have a sheet for each leg, in which they go straight on into the other.
TEST(ShellMap, MitresTheInsideOfACorner) {
  const double edge = 0.02;
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 25; ++i) samples.emplace_back(-0.5 + 0.02 * i, 0, 0);
  for (int i = 1; i <= 25; ++i) samples.emplace_back(0, 0.02 * i, 0);
  const Laid laid(test::plane(0.8, edge, 7), shell_radius, samples);
  const ShellMap map(laid.ground());
  const double corner = laid.chart.length / 2;
  int mitred = 0;
  for (double along = 0.03; along < 0.3; along += 0.007) {
    for (const double d : {0.03, 0.08, 0.14, 0.19}) {
      const double inside = std::min(d, along);
      for (const bool first : {true, false}) {
        const auto place = [&](double beside) {
          return first ? Vec3d(-along, beside, 0.1) : Vec3d(-beside, along, 0.1);
        };
        const Vec3d at = map(first ? corner - along : corner + along, d, 0.1);
        const double off_mitre = (at - place(inside)).norm(), off_sheet = (at - place(d)).norm();
        EXPECT_LT(std::min(off_mitre, along > 0.07 ? off_sheet : 1), 2.5 * edge) << along << ' ' << d;
        if (d > along && off_mitre < off_sheet) ++mitred;
      }
    }
  }
  EXPECT_GT(mitred, 30);
}

TEST(ShellMap, EndsAtTheBorderOfTheSurface) {
  const double edge = 0.02, border = 0.5;
  const Laid laid(test::plane(border, edge, 7), shell_radius,
                  test::sampled(30, [](double s) { return Vec3d(0.8 * s - 0.4, 0.4, 0); }));
  const ShellMap map(laid.ground());
  for (double t = 0.05; t < 0.75; t += 0.013) {
    for (const double d : {0.05, 0.12, 0.2}) {
      const Vec3d known(t - 0.4, std::min(0.4 + d, border), 0.1);
      EXPECT_LT((map(t, d, 0.1) - known).norm(), 0.1 * edge) << t << ' ' << d;
    }
  }
}

// The second leg crosses the first at right angles.
TEST(ShellMap, UsesTheSheetOfEachT) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 30; ++i) samples.emplace_back(-0.6 + 0.04 * i, 0, 0);
  for (int i = 1; i < 30; ++i) {
    const double angle = 1.5 * pi * i / 30;
    samples.emplace_back(0.6 + 0.6 * std::sin(angle), 0.6 - 0.6 * std::cos(angle), 0);
  }
  for (int i = 0; i <= 30; ++i) samples.emplace_back(0, 0.6 - 0.04 * i, 0);
  const Laid laid(test::plane(1.5, 0.02, 7), shell_radius, samples);
  const ShellMap map(laid.ground());
  for (double from = -0.3; from <= 0.3; from += 0.02) {
    for (const double d : {-0.18, -0.07, 0., 0.1, 0.19}) {
      EXPECT_LT((map(0.6 + from, d, 0.1) - Vec3d(from, d, 0.1)).norm(), 2e-3) << from << ' ' << d;
      const double t = laid.chart.length - 0.6 + from;
      EXPECT_LT((map(t, d, -0.1) - Vec3d(d, -from, -0.1)).norm(), 2e-3) << from << ' ' << d;
    }
  }
}

TEST(ShellMap, LiesAtTheNearerSideOfAGap) {
  const double edge = 0.02;
  TriangleMesh mesh = test::plane(0.8, edge, 7);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(t, [&](Index v) { return std::abs(mesh.positions[v].x()) < 0.03F; });
  });
  const Laid laid(mesh, shell_radius, test::sampled(30, [](double s) { return Vec3d(s - 0.5, 0.02, 0); }));
  const ShellMap map(laid.ground());
  for (double t = 0.3; t < laid.chart.length - 0.3; t += 0.004) {
    const Vec3d at = map(t, 0.1, 0.1);
    EXPECT_GT(at.y(), 0.02 - edge) << t;
    EXPECT_LT(at.y(), 0.12 + edge) << t;
    EXPECT_NEAR(at.z(), 0.1, 1e-6) << t;
    EXPECT_NEAR(at.x(), t - 0.5, 0.05 + edge) << t;
  }
}

TEST(ShellMap, NeedsTriangles) {
  const Laid laid(test::plane(0.8, 0.1, 7), shell_radius, {Vec3d(0, 0, 0)});
  SolidGround ground = laid.ground();
  const Chart none;
  EXPECT_THROW(ShellMap({ground.surface, none, ground.position}), Error);
}

}  // namespace
}  // namespace burin
