// Tests charts over base surfaces where the surface comes near itself: thin plates, tubes thinner than the
// brush, parts in contact. Exact distances are those of the unrolled surface.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double sheet_radius = 1;

/// A plate |x| <= 4, |y| <= half_width whose upper side is at z = 0, joined around its long borders with the
/// lower one at z = -thickness; open at the short ones.
struct Plate {
  double half_width, thickness;

  double around() const { return 4 * half_width + 2 * thickness; }

  /// The point at the distance `way` around from the middle of the upper side; y > 0 is to the left.
  Vec3d place(double x, double way) const {
    const double side = way < 0 ? -1 : 1, beyond = std::abs(way) - half_width;
    if (beyond <= 0) return {x, way, 0};
    if (beyond <= thickness) return {x, side * half_width, -beyond};
    return {x, side * (half_width - (beyond - thickness)), -thickness};
  }

  TriangleMesh mesh(double edge) const {
    const int cells = static_cast<int>(std::lround(around() / edge));
    return test::shuffled(test::patch({.u_min = 0,
                                       .u_max = around(),
                                       .v_min = -4,
                                       .v_max = 4,
                                       .cells_u = cells,
                                       .cells_v = static_cast<int>(std::lround(8 / edge)),
                                       .wrap_u = true},
                                      [this](double way, double x) {
                                        return place(-x, way <= around() / 2 ? way : way - around());
                                      }),
                          3);
  }

  /// The way around from the middle of the upper side.
  double way_of(const Vec3f& at) const {
    const double y = at.y(), z = at.z(), side = y < 0 ? -1 : 1;
    if (z > -1e-6) return y;
    if (z < -thickness + 1e-6) return side * (2 * half_width + thickness - std::abs(y));
    return side * (half_width - z);
  }
};

std::vector<Vec3d> along_x(double y) {
  return test::sampled(100, [=](double s) { return Vec3d(-2.5 + 5 * s, y, 0); });
}

// The middle of a wide plate: its other side is far along the surface.
TEST(BasePlates, HaveTwoSidesHoweverThin) {
  for (const double thickness : {0.3, 0.1, 0.02}) {
    const Plate plate{2.5, thickness};
    test::Charted on(plate.mesh(0.05));
    const Chart chart = on.chart({.radius = sheet_radius, .follow = 0}, along_x(0));
    ASSERT_NE(on.builder.base(), nullptr);
    std::size_t upper = 0;
    for (std::size_t i = 0; i < chart.size(); ++i) {
      const Vec3f& at = on.surface.positions[chart.vertex[i]];
      ASSERT_EQ(at.z(), 0) << "thickness " << thickness;
      ASSERT_GT(chart.normal[i].z(), 0.999F);
      if (chart.t[i] < sheet_radius / 3 || chart.t[i] > on.curve.length() - sheet_radius / 3) continue;
      ++upper;
      EXPECT_NEAR(chart.d[i], at.y(), 0.002 * sheet_radius);
      EXPECT_NEAR(chart.t[i], at.x() + 2.5, 0.002 * sheet_radius);
    }
    EXPECT_GT(upper, 3000U);
  }
}

// The stroke runs beside a sharp rim. It covers the upper side, and the lower one up to the radius
// measured around the rim.
TEST(BasePlates, AreGoneAroundAtTheirRims) {
  const Plate plate{2, 0.3};
  test::Charted on(plate.mesh(0.05));
  const Chart chart = on.chart({.radius = sheet_radius, .follow = 0}, along_x(1.6));
  std::vector<std::size_t> node_of(on.surface.vertex_count(), chart.size());
  for (std::size_t i = 0; i < chart.size(); ++i) node_of[chart.vertex[i]] = i;
  std::size_t inside = 0, missing = 0, strayed = 0;
  double upper_error = 0, other_error = 0;
  std::size_t uppers = 0, others = 0;
  for (Index v = 0; v < on.surface.vertex_count(); ++v) {
    const Vec3f& at = on.surface.positions[v];
    const double d = plate.way_of(at) - 1.6;
    const bool in_middle = std::abs(at.x()) < 2;
    if (node_of[v] < chart.size() && std::abs(d) > 1.2 * sheet_radius) ++strayed;
    if (!in_middle || std::abs(d) > 0.8 * sheet_radius) continue;
    ++inside;
    if (node_of[v] == chart.size()) {
      ++missing;
      continue;
    }
    const double error = std::abs(static_cast<double>(chart.d[node_of[v]]) - d) / sheet_radius;
    (at.z() > -1e-6F ? upper_error : other_error) += error;
    ++(at.z() > -1e-6F ? uppers : others);
  }
  EXPECT_GT(inside, 2000U);
  EXPECT_EQ(missing, 0U);
  EXPECT_EQ(strayed, 0U);
  EXPECT_LE(upper_error / static_cast<double>(uppers), 0.03);
  EXPECT_LE(other_error / static_cast<double>(others), 0.2);
}

// The stroke runs along a ruling; t and d are the distances along and around the unrolled tube. Heights are
// averaged over more than the width of the thinnest tube, which makes its base surface thinner.
TEST(BaseTubes, MayBeThinnerThanTheBrush) {
  constexpr double reach = 0.55 * sheet_radius / 2;  // see BaseSurface
  for (const double tube : {1.5, 0.7, 0.5, 0.25}) {
    test::Charted on(test::shuffled(test::cylinder(tube, 4, 0.05, 0.3, 2), 3));
    const Chart chart = on.chart({.radius = sheet_radius, .follow = 0},
                                 test::sampled(100, [=](double s) { return Vec3d(tube, 0, -2.5 + 5 * s); }));
    ASSERT_NE(on.builder.base(), nullptr);
    std::vector<std::size_t> node_of(on.surface.vertex_count(), chart.size());
    for (std::size_t i = 0; i < chart.size(); ++i) node_of[chart.vertex[i]] = i;
    double t_sum = 0, d_sum = 0;
    std::size_t inside = 0, missing = 0, strayed = 0;
    for (Index v = 0; v < on.surface.vertex_count(); ++v) {
      const Vec3f& at = on.surface.positions[v];
      const double d = tube * std::abs(std::atan2(at.y(), at.x())), t = at.z() + 2.5;
      if (node_of[v] < chart.size() && d > 1.05 * sheet_radius) ++strayed;
      if (t < 0.5 || t > 4.5 || d > 0.95 * sheet_radius) continue;
      ++inside;
      if (node_of[v] == chart.size()) {
        ++missing;
        continue;
      }
      d_sum += std::abs(std::abs(static_cast<double>(chart.d[node_of[v]])) - d);
      t_sum += std::abs(chart.t[node_of[v]] - t);
    }
    const auto found = static_cast<double>(inside - missing);
    EXPECT_GT(inside, 1000U);
    EXPECT_EQ(missing, 0U) << "tube of " << tube;
    EXPECT_EQ(strayed, 0U) << "tube of " << tube;
    EXPECT_LE(t_sum / found, 0.01 * sheet_radius) << "tube of " << tube;
    EXPECT_LE(d_sum / found, (tube < reach ? 0.025 : 0.01) * sheet_radius) << "tube of " << tube;
  }
}

// Two sheets, not joined, at a hundredth of an edge from each other.
TEST(BaseParts, AreNotJoinedByContact) {
  TriangleMesh mesh = test::plane(3, 0.05, 4);
  TriangleMesh below = test::plane(3, 0.05, 5);
  const auto offset = static_cast<Index>(mesh.positions.size());
  for (const Vec3f& at : below.positions) mesh.positions.push_back(at - Vec3f(0, 0, 0.0005F));
  for (const auto& [a, b, c] : below.triangles)
    mesh.triangles.push_back({a + offset, c + offset, b + offset});
  test::Charted on(test::shuffled(mesh, 6));
  const Chart chart =
      on.chart({.radius = sheet_radius, .follow = 0},
               test::sampled(60, [](double s) { return Vec3d(-1.5 + 3 * s, 0.3 * std::sin(4 * s), 0.01); }));
  ASSERT_GT(chart.size(), 3000U);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    ASSERT_EQ(on.surface.positions[chart.vertex[i]].z(), 0);
    ASSERT_GT(chart.normal[i].z(), 0.999F);
  }
}

}  // namespace
}  // namespace burin
