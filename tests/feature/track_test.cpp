#include <burin/base/error.h>
#include <burin/feature/snapped_curve.h>
#include <burin/feature/track.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

#include "feature/known_lines.h"
#include "support/closed_curve.h"
#include "support/shapes.h"
#include "support/shared_data.h"
#include "support/traced.h"

namespace burin::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A torus about the z axis.
struct Torus {
  static constexpr double large = 1, small = 0.4, edge = 0.0489;

  static Vec3d at(double u, double v) {
    const double from_axis = large + small * std::cos(v);
    return {from_axis * std::cos(u), from_axis * std::sin(u), small * std::sin(v)};
  }
  static double u(const Vec3d& x) { return std::atan2(x.y(), x.x()); }
  static double v(const Vec3d& x) { return std::atan2(x.z(), std::hypot(x.x(), x.y()) - large); }

  /// The v of the outer silhouette at u, of n . view = 0 with n = (cos v cos u, cos v sin u, sin v).
  static double silhouette(double u, const Vec3d& view) {
    return std::atan2(-(std::cos(u) * view.x() + std::sin(u) * view.y()), view.z());
  }

  TriangleMesh mesh() const {
    return shuffled(patch({0, 2 * pi, -pi, pi, 150, 60, true, 0.3, 0.3, 3}, at), 5);
  }
};

/// The distance of a point of a torus from the nearer sheet of its silhouette, edges.
double torus_error(const Vec3d& x, const Vec3d& view) {
  double least = 1e9;
  for (int i = -300; i <= 300; ++i) {
    const double u = Torus::u(x) + i * 1e-3;
    for (const double sheet : {0., pi})
      least = std::min(least, (Torus::at(u, Torus::silhouette(u, view) + sheet) - x).norm());
  }
  return least / Torus::edge;
}

Vec3d seen_from(double azimuth, double elevation) {
  return -Vec3d(std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
                std::sin(elevation));
}

/// The closed outer silhouette of a torus, tracked from this view on.
TrackedLine torus_line(SnapScene& scene, const Vec3d& view) {
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 100; ++i) {
    const double u = 2 * pi * i / 100;
    pen.push_back(Torus::at(u, Torus::silhouette(u, view) + 0.1));
  }
  return tracked(scene.snap_closed(pen, {FeatureKind::silhouette, {false, view}}, {.radius = 0.25}).curve);
}

TEST(Track, FollowsASilhouetteWhileTheCameraGoesAroundATorus) {
  SnapScene scene(Torus().mesh());
  LineTracker tracker(scene.surface, scene.picker);
  TrackedLine line = torus_line(scene, seen_from(0, 0.7));
  double most_moved = 0, worst = 0;
  for (int step = 1; step <= 90; ++step) {
    const Vec3d view = seen_from(step * pi / 180, 0.7);
    const TrackStep made =
        tracker.follow(line, {FeatureKind::silhouette, {false, view}}, {.snap = {.radius = 0.25}});
    ASSERT_TRUE(made.losses.empty()) << "step " << step;
    ASSERT_EQ(made.lines.size(), 1u);
    line = made.lines.front();
    ASSERT_TRUE(line.curve.closed);
    EXPECT_TRUE(std::ranges::is_sorted(line.start_t));
    EXPECT_NEAR(line.start_t.back() - line.start_t.front(), line.start_length, 0.1);
    most_moved = std::max(most_moved, made.most_moved / Torus::edge);
    if (step % 10 != 0) continue;
    for (const CurvePoint& point : line.curve.points)
      worst = std::max(worst, torus_error(point.at.position.cast<double>(), view));
  }
  std::cout << "greatest move of a step " << most_moved << ", greatest error " << worst << " edges\n";
  EXPECT_LT(most_moved, 0.2);
  EXPECT_LT(worst, 0.1);
}

TEST(Track, TellsWhereASilhouetteChangesItsTopology) {
  // From the side, at the 60th step, the outer and the inner silhouette touch at four points, where
  // cos u = 0 and cos v = 0. Then each goes on as a part of the other.
  SnapScene scene(Torus().mesh());
  LineTracker tracker(scene.surface, scene.picker);
  std::vector<TrackedLine> lines = {torus_line(scene, seen_from(0.3, pi / 3))};
  int splits = 0;
  double worst = 0;
  for (int step = 1; step <= 90; ++step) {
    const Vec3d view = seen_from(0.3, pi / 3 - step * pi / 180);
    std::vector<TrackedLine> next;
    for (const TrackedLine& line : lines) {
      const TrackStep made =
          tracker.follow(line, {FeatureKind::silhouette, {false, view}}, {.snap = {.radius = 0.25}});
      EXPECT_LE(made.most_moved, 2 * made.snapped.edge);
      EXPECT_TRUE(made.losses.empty() || (step > 60 && step <= 62)) << "step " << step;
      for (const Loss& loss : made.losses) {
        splits += loss.kind == LossKind::split;
        const Vec3d at = stroke_position(line.curve, (loss.from + loss.to) / 2);
        EXPECT_NEAR(std::abs(Torus::v(at)), pi / 2, 0.35);
        EXPECT_NEAR(std::abs(std::cos(Torus::u(at) - 0.3)), 0, 0.35);
      }
      next.insert(next.end(), made.lines.begin(), made.lines.end());
    }
    lines = next;
    if (step % 10 != 9) continue;
    for (const TrackedLine& line : lines)
      for (const CurvePoint& point : line.curve.points)
        worst = std::max(worst, torus_error(point.at.position.cast<double>(), view));
  }
  std::cout << "greatest error " << worst << " edges\n";
  EXPECT_EQ(splits, 4);
  EXPECT_EQ(lines.size(), 4u);
  EXPECT_LT(worst, 0.7) << "a degree before the sheets touch; else below 0.1";
}

TEST(Track, KeepsTheIdentityOfPoints) {
  // While the view of a sphere turns about an axis its silhouette does so too, and its points move at right
  // angles to it: they turn about that axis.
  SnapScene scene(shuffled(sphere(5, 0.25, 3), 4));
  constexpr double edge = 0.0384;
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) {
    const double polar = 0.4 + 1.6 * i / 60;
    pen.emplace_back(std::sin(polar), 0.02, std::cos(polar));
  }
  const SurfaceCurve first =
      scene.snap(pen, {FeatureKind::silhouette, {false, Vec3d::UnitY()}}, {.radius = 0.25}).curve;
  LineTracker tracker(scene.surface, scene.picker);
  TrackedLine line = tracked(first);
  Eigen::AngleAxisd turned(0, Vec3d::UnitZ());
  for (int step = 1; step <= 45; ++step) {
    turned.angle() = step * pi / 90;
    const Feature feature{FeatureKind::silhouette, {false, turned * Vec3d::UnitY()}};
    const TrackStep made = tracker.follow(line, feature, {.snap = {.radius = 0.25}});
    ASSERT_EQ(made.lines.size(), 1u);
    line = made.lines.front();
  }
  double worst = 0;
  for (std::size_t i = 0; i < line.curve.points.size(); ++i) {
    const Vec3d expected = turned * stroke_position(first, line.start_t[i]);
    worst = std::max(worst, (line.curve.points[i].at.position.cast<double>() - expected).norm() / edge);
  }
  std::cout << "greatest drift after 90 degrees " << worst << " edges\n";
  EXPECT_LT(worst, 1);
  EXPECT_NEAR(line.curve.length(), first.length(), edge);
}

/// A plane with a ridge along y = at that ends at x = `end`.
TriangleMesh ridge_mesh(double at, double end) {
  return patch({-40, 40, -20, 20, 92, 46, false, 0.3, 0.3, 3}, [=](double x, double y) {
    const double fading = x < end ? 1 : std::exp(-(x - end) * (x - end) / 18);
    return Vec3d(x, y, 2 * fading * std::exp(-(y - at) * (y - at) / 18));
  });
}

TEST(Track, FollowsAFeatureOfAChangingSurface) {
  const auto first = std::make_unique<SnapScene>(ridge_mesh(0, 100));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.emplace_back(i - 30, 1, 0);
  TrackedLine line = tracked(first->snap(pen, {FeatureKind::ridge}, {.radius = 8, .scale = 1.5}).curve);
  for (int step = 1; step <= 20; ++step) {
    const SnapScene now(step % 2 ? shuffled(ridge_mesh(step * 0.3, 100), 3) : ridge_mesh(step * 0.3, 100));
    LineTracker tracker(now.surface, now.picker);
    const TrackStep made = tracker.follow(line, {FeatureKind::ridge}, {.snap = {.radius = 8, .scale = 1.5}});
    ASSERT_EQ(made.lines.size(), 1u) << "step " << step;
    EXPECT_TRUE(made.losses.empty());
    line = made.lines.front();
  }
  for (const CurvePoint& point : line.curve.points) EXPECT_NEAR(point.at.position.y(), 6, 0.3);

  const SnapScene ended(ridge_mesh(6, 0));
  LineTracker tracker(ended.surface, ended.picker);
  const TrackStep made = tracker.follow(line, {FeatureKind::ridge}, {.snap = {.radius = 8, .scale = 1.5}});
  ASSERT_EQ(made.lines.size(), 1u);
  ASSERT_EQ(made.losses.size(), 1u);
  EXPECT_EQ(made.losses[0].kind, LossKind::ended);
  EXPECT_NEAR(made.losses[0].from, 30 + 8, 6) << "where the ridge has fallen to a thirtieth";
  EXPECT_NEAR(made.losses[0].to, line.curve.length(), 1e-9);
}

TEST(Track, DropsWhatWouldJump) {
  SnapScene now(ridge_mesh(3, 100));
  std::vector<Vec3d> pen;
  for (int i = 0; i <= 60; ++i) pen.emplace_back(i - 30, i < 30 ? 2 : 0, 0);
  const SnapScene flat(plane(60, 1, 3));
  const TrackedLine line = tracked(traced(flat.surface, flat.picker, 8, pen));
  LineTracker tracker(now.surface, now.picker);
  const TrackStep made = tracker.follow(line, {FeatureKind::ridge}, {.snap = {.radius = 8, .scale = 1.5}});
  ASSERT_EQ(made.losses.size(), 1u);
  EXPECT_EQ(made.losses[0].kind, LossKind::jumped);
  EXPECT_NEAR(made.losses[0].from, 30, 3);
  ASSERT_EQ(made.lines.size(), 1u);
  EXPECT_NEAR(made.lines[0].curve.length(), 30, 3);
  EXPECT_LE(made.most_moved, 2 * made.snapped.edge);
}

/// The outline of a mesh on the right of a view along `view`, from below upwards.
std::vector<Vec3d> right_outline(const Picker& picker, const Vec3d& view, double low, double high) {
  const Vec3d right = view.cross(Vec3d::UnitY());
  std::vector<Vec3d> outline;
  for (int i = 0; i <= 60; ++i) {
    for (double out = 0.2; out > -0.2; out -= 2e-4) {
      const Vec3d from = out * right - view + Vec3d(0, low + (high - low) * i / 60, 0);
      const auto hit = picker.pick({from.cast<float>(), view.cast<float>()});
      if (!hit) continue;
      outline.push_back(hit->position.cast<double>());
      break;
    }
  }
  return outline;
}

TEST(Track, FollowsAnOutlineOfAScanAndTellsWhatItLoses) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/stanford-bunny.obj");
  SnapScene scene(triangulate(read_mesh(path)));
  LineTracker tracker(scene.surface, scene.picker);
  double radius = 0.012;
  const auto view_of = [](int step) {
    return Vec3d(std::cos(step * pi / 180), 0, std::sin(step * pi / 180));
  };
  int followed_wholly = 0, followed = 0, losses = 0, to_the_end = 0;
  std::vector<double> facing;
  const auto follow_from = [&](int begin) {
    const SnapResult first =
        scene.snap(right_outline(scene.picker, view_of(begin), 0.04, 0.11),
                   {FeatureKind::silhouette, {false, view_of(begin)}}, {.radius = radius});
    std::vector<TrackedLine> lines = {tracked(first.curve)};
    for (int step = begin + 1; step <= begin + 90; ++step) {
      std::vector<TrackedLine> next;
      for (const TrackedLine& line : lines) {
        const TrackStep made = tracker.follow(line, {FeatureKind::silhouette, {false, view_of(step)}},
                                              {.snap = {.radius = radius}});
        EXPECT_LE(made.most_moved, 2 * made.snapped.edge);
        followed += static_cast<int>(made.lines.size());
        losses += static_cast<int>(made.losses.size());
        if (made.losses.empty()) {
          ++followed_wholly;
          ASSERT_EQ(made.lines.size(), 1u);
          EXPECT_NEAR(made.lines[0].start_t.front(), line.start_t.front(), radius / 100);
          EXPECT_NEAR(made.lines[0].start_t.back(), line.start_t.back(), radius / 100);
        }
        for (const TrackedLine& part : made.lines)
          for (const CurvePoint& point : part.curve.points)
            facing.push_back(std::abs(point.normal.cast<double>().dot(view_of(step))));
        next.insert(next.end(), made.lines.begin(), made.lines.end());
      }
      lines = next;
    }
    to_the_end += static_cast<int>(lines.size());
  };
  // What is lost hangs on details: with radii a percent apart one in 3.5 to one in 4.2 steps loses something.
  for (const double share : {0.98, 1., 1.02}) {
    radius = 0.012 * share;
    for (const int begin : {0, 90, 180, 270}) follow_from(begin);
  }
  std::ranges::sort(facing);
  std::cout << followed << " lines followed, " << followed_wholly << " wholly, " << losses << " losses, "
            << to_the_end << " at the end, n . v median " << quantile(facing, 0.5) << ", p95 "
            << quantile(facing, 0.95) << '\n';
  EXPECT_GT(to_the_end, 0) << "something can be followed for 90 degrees";
  EXPECT_GT(2 * followed_wholly, 5 * losses);
  EXPECT_LT(quantile(facing, 0.5), 0.04);
}

TEST(Track, RefusesLinesWithoutIdentities) {
  SnapScene scene(plane(5, 1, 3));
  LineTracker tracker(scene.surface, scene.picker);
  TrackedLine line = tracked(traced(scene.surface, scene.picker, 1, {{-2, 0, 0}, {2, 0, 0}}));
  EXPECT_THROW(tracker.follow(line, {}, {.snap = {.radius = 1}, .most_edges = 0}), ContractError);
  line.start_t.pop_back();
  EXPECT_THROW(tracker.follow(line, {}, {.snap = {.radius = 1}}), ContractError);
}

}  // namespace
}  // namespace burin::test
