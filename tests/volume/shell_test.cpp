// Shells over charts whose coordinates are known.
#include <burin/volume/shell.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double radius = 0.2;

struct Shelled {
  test::Charted charted;
  Chart chart;
  std::vector<Prism> prisms;

  Shelled(TriangleMesh mesh, const std::vector<Vec3d>& samples)
      : charted(std::move(mesh)),
        chart(charted.chart({.radius = radius}, samples)),
        prisms(
            shell_over({charted.surface, chart, [this](Index v) { return charted.surface.positions[v]; }})) {}

  std::vector<ShellPoint> feet(const Vec3d& p) const {
    std::vector<ShellPoint> feet;
    for (const Prism& prism : prisms) prism.find(p, [&](const ShellPoint& point) { feet.push_back(point); });
    return feet;
  }
};

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.;
}

TEST(Shell, HasTheCoordinatesOfAPlaneExactly) {
  const Shelled shelled(test::plane(1, 0.04, 7),
                        test::sampled(30, [](double s) { return Vec3d(s - 0.5, 0.02, 0); }));
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const double t = uniform(random, 0, 1), d = uniform(random, -0.14, 0.14), h = uniform(random, -0.3, 0.3);
    const std::vector<ShellPoint> feet = shelled.feet({t - 0.5, 0.02 + d, h});
    ASSERT_GE(feet.size(), 1u);
    for (const ShellPoint& foot : feet) {
      EXPECT_NEAR(foot.t, t, 1e-5);
      EXPECT_NEAR(static_cast<double>(foot.d), d, 1e-5);
      EXPECT_NEAR(static_cast<double>(foot.h), h, 1e-5);
      EXPECT_NEAR(static_cast<double>(foot.weights.sum()), 1, 1e-5);
    }
  }
}

// Of a sphere's chart heights are distances from it, and t and d angles, to second order in an edge.
TEST(Shell, HasTheCoordinatesOfASphere) {
  const Shelled shelled(test::sphere(5, 0.2, 4),
                        test::sampled(60, [](double s) { return Vec3d(std::cos(s), std::sin(s), 0); }));
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const double t = uniform(random, 0.05, 0.95), d = uniform(random, -0.13, 0.13),
                 h = uniform(random, -0.4, 0.4);
    const Vec3d up(std::cos(d) * std::cos(t), std::cos(d) * std::sin(t), std::sin(d));
    const std::vector<ShellPoint> feet = shelled.feet((1 + h) * up);
    ASSERT_GE(feet.size(), 1u) << t << ' ' << d << ' ' << h;
    EXPECT_NEAR(feet[0].t, t, 2e-4);
    EXPECT_NEAR(static_cast<double>(feet[0].d), d, 2e-4);
    EXPECT_NEAR(static_cast<double>(feet[0].h), h, 5e-4);
  }
}

TEST(Shell, EndsAtTheFocalSurface) {
  const Shelled shelled(test::sphere(5, 0.2, 4),
                        test::sampled(60, [](double s) { return Vec3d(std::cos(s), std::sin(s), 0); }));
  const Vec3d up(std::cos(0.5), std::sin(0.5), 0);
  EXPECT_FALSE(shelled.feet(0.2 * up).empty());
  EXPECT_TRUE(shelled.feet(-0.2 * up).empty());
}

// Off the chart's rim there is one triangle more, so that no gap is left between the runs of a corner. Right
// at the corner coordinates are no finer than the triangles.
TEST(Shell, HasNoGapWithinACorner) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 20; ++i) samples.emplace_back(-0.5 + 0.025 * i, 0, 0);
  for (int i = 1; i <= 20; ++i) samples.emplace_back(0.0125 * i, 0.0217 * i, 0);
  const Shelled shelled(test::plane(1, 0.02, 7), samples);
  std::mt19937 random(9);
  int tried = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3d p(uniform(random, -0.15, 0.15), uniform(random, 0, 0.15), uniform(random, -0.1, 0.1));
    const Vec3d flat(p.x(), p.y(), 0);
    const auto from = [&](const Vec3d& along) {
      return (flat - std::max(flat.dot(along), 0.) * along).norm();
    };
    const double least = std::min(from({-1, 0, 0}), from(Vec3d(0.0125, 0.0217, 0).normalized()));
    if (least > 0.14) continue;
    ++tried;
    const std::vector<ShellPoint> feet = shelled.feet(p);
    ASSERT_FALSE(feet.empty()) << p.transpose();
    const auto nearest = std::ranges::min(feet, {}, [](const ShellPoint& foot) { return std::abs(foot.d); });
    const double edges = flat.norm() < 0.05 ? 1 : 0.35;
    EXPECT_NEAR(static_cast<double>(std::abs(nearest.d)), least, edges * 0.02) << p.transpose();
  }
  EXPECT_GT(tried, 2000);
}

TEST(Shell, BoxesHoldWhatTheirPrismsDo) {
  const Shelled shelled(test::sphere(4, 0.2, 4),
                        test::sampled(60, [](double s) { return Vec3d(std::cos(s), std::sin(s), 0); }));
  std::mt19937 random(7);
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const double angle = uniform(random, 0, 1), h = uniform(random, -0.3, 0.3),
                 side = uniform(random, -0.1, 0.1);
    const Vec3d p = (1 + h) * Vec3d(std::cos(angle), std::sin(angle), side).normalized();
    for (const Prism& prism : shelled.prisms) {
      prism.find(p, [&](const ShellPoint& point) {
        if (std::abs(point.h) > 0.29F) return;
        ++found;
        EXPECT_TRUE(prism.box(-0.3, 0.3).contains(p));
        const double along = p[prism.axis()];
        EXPECT_TRUE(prism.layer(-0.3, 0.3, along - 1e-5, along + 1e-5).contains(p));
      });
    }
  }
  EXPECT_GT(found, 1000);
}

}  // namespace
}  // namespace burin
