#include <burin/stroke/curve/surface_curve.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;

struct Ground {
  Surface surface;
  Picker picker;
  explicit Ground(const TriangleMesh& mesh) : surface(make_surface(mesh)), picker(surface) {}

  CurveTracer trace(const std::vector<Vec3d>& places, double radius) const {
    CurveTracer tracer(surface, picker, radius);
    double time = 0;
    for (const Vec3d& place : places) {
      tracer.add(*picker.closest(place.cast<float>(), 1), time, {});
      time += 0.01;
    }
    return tracer;
  }
};

const Ground& ground() {
  static const Ground plane(test::plane(1, 0.02, 1));
  return plane;
}

/// Along the circle of radius 0.5 through these angles.
std::vector<Vec3d> arc(double from, double to, int samples) {
  std::vector<Vec3d> places;
  for (int i = 0; i < samples; ++i) {
    const double angle = from + (to - from) * i / (samples - 1);
    places.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0);
  }
  return places;
}

/// That t rises by the steps of the curve, all the way around, and that tangents turn no more at the seam
/// than anywhere.
void expect_no_seam(const SurfaceCurve& curve, double largest_turn) {
  ASSERT_TRUE(curve.closed);
  const auto& points = curve.points;
  EXPECT_EQ(points[0].t, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint &from = points[i], &to = points[curve.next(i)];
    const double step = curve.segment_end(i) - from.t, chord = (to.at.position - from.at.position).norm();
    ASSERT_GT(step, 0) << i;
    ASSERT_NEAR(step, chord, 0.01 * chord + 1e-6) << i;
    ASSERT_LT((to.tangent - from.tangent).norm(), largest_turn) << i;
    ASSERT_GT((to.at.position - from.at.position).dot(from.tangent), 0.9 * chord) << i;
  }
}

TEST(ClosedCurve, IsTheCircleWhoseSamplesItWasGiven) {
  // Open by a step, back on the first sample, a little short of it, beyond it.
  for (const double end : {2 * pi - 2 * pi / 40, 2 * pi, 2 * pi - 0.1, 2 * pi + 0.5}) {
    SCOPED_TRACE(end);
    const CurveTracer tracer = ground().trace(arc(0, end, 40), 0.2);
    EXPECT_TRUE(tracer.came_back());
    const auto curve = tracer.closed_curve(Closure::automatic);
    ASSERT_TRUE(curve.has_value());
    expect_no_seam(*curve, 0.06f);
    EXPECT_NEAR(curve->length(), pi, 1e-3);
    for (const CurvePoint& point : curve->points) EXPECT_NEAR(point.at.position.norm(), 0.5, 4e-4);
  }
}

TEST(ClosedCurve, GoesRoundAGreatCircle) {
  const Ground sphere(test::sphere(6, 0.2, 3));
  std::vector<Vec3d> places;
  const Vec3d x = Vec3d(1, 2, 3).normalized(), y = x.unitOrthogonal();
  for (int i = 0; i < 48; ++i)
    places.push_back(std::cos(2 * pi * i / 48) * x + std::sin(2 * pi * i / 48) * y);
  const auto curve = sphere.trace(places, 0.2).closed_curve(Closure::closed);
  ASSERT_TRUE(curve.has_value());
  expect_no_seam(*curve, 0.06f);
  EXPECT_NEAR(curve->length(), 2 * pi, 3e-3);
}

TEST(ClosedCurve, DoesNotMindAHandThatShakes) {
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.002);
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec3d> places = arc(0, 2 * pi + std::abs(150 * noise(random)), 200);
    for (Vec3d& place : places) place += Vec3d(noise(random), noise(random), 0);
    const auto curve = ground().trace(places, 0.2).closed_curve(Closure::automatic);
    ASSERT_TRUE(curve.has_value()) << round;
    EXPECT_NEAR(curve->length(), pi, 0.15) << round;
    for (std::size_t i = 0; i < curve->points.size(); ++i) {
      const Vec3f &a = curve->points[i].tangent, &b = curve->points[curve->next(i)].tangent;
      EXPECT_GT(a.dot(b), 0.3f) << round << " " << i;
    }
  }
}

TEST(ClosedCurve, IsSeenOnlyWhereThePenComesBack) {
  EXPECT_FALSE(ground().trace(arc(0, 1.5 * pi, 40), 0.2).came_back()) << "an open arc";
  EXPECT_FALSE(ground().trace(arc(0, 2 * pi - 0.25, 40), 0.2).came_back()) << "short by more than 0.1";
  EXPECT_TRUE(ground().trace(arc(0, 2 * pi - 0.19, 40), 0.2).came_back());
  EXPECT_FALSE(ground().trace(arc(0, 2 * pi, 40), 0.8).came_back()) << "not four radii long";

  std::vector<Vec3d> spiral, u_turn, square;
  for (int i = 0; i <= 100; ++i) {
    const double s = i / 100.;
    spiral.push_back((0.3 + 0.12 * 3 * s) * Vec3d(std::cos(6 * pi * s), std::sin(6 * pi * s), 0));
    u_turn.emplace_back(s < 0.5 ? 2 * s - 0.5 : 1.5 - 2 * s, s < 0.5 ? 0 : 0.02, 0);
    const double along = 3.2 * (s - std::floor(4 * s) / 4) - 0.4;
    const Vec3d sides[] = {{along, -0.4, 0}, {0.4, along, 0}, {-along, 0.4, 0}, {-0.4, -along, 0}};
    square.push_back(i < 100 ? sides[i / 25] : Vec3d(-0.4, -0.4, 0));
  }
  EXPECT_FALSE(ground().trace(spiral, 0.2).came_back());
  EXPECT_FALSE(ground().trace(u_turn, 0.2).came_back()) << "the other way round";
  EXPECT_FALSE(ground().trace(square, 0.2).came_back()) << "at a right angle to where it began";
  EXPECT_FALSE(ground().trace({{0.1, 0.1, 0}}, 0.01).came_back()) << "one sample";
}

TEST(ClosedCurve, ClosesAnythingWhenTold) {
  const CurveTracer half = ground().trace(arc(0, pi, 20), 0.1);
  EXPECT_FALSE(half.closed_curve(Closure::open).has_value());
  EXPECT_FALSE(half.closed_curve(Closure::automatic).has_value());
  const auto curve = half.closed_curve(Closure::closed);
  ASSERT_TRUE(curve.has_value());
  EXPECT_GT(curve->length(), pi / 2 + 1);
  EXPECT_LT(curve->closing_length, 0.02);
  // The pen needs as long for the gap as for as much of the arc.
  EXPECT_NEAR(pen_at(*curve, curve->length() - 1e-6).time, 0.19 * (1 + 2 / pi), 0.01);
  EXPECT_LT(pen_at(*curve, 0.02).time, 0.005);
  EXPECT_NEAR(pen_at(*curve, 0.5).time, 0.19 * 0.5 / (pi / 2), 0.01);
  EXPECT_FALSE(ground().trace({{0, 0, 0}, {0.5, 0, 0}}, 0.1).closed_curve(Closure::closed).has_value());
  EXPECT_FALSE(CurveTracer(ground().surface, ground().picker, 0.1).closed_curve(Closure::closed).has_value());
}

TEST(ClosedCurve, StaysOpenAcrossAGap) {
  TriangleMesh bent = test::plane(1, 0.05, 1);
  // Two walls far from each other, joined below.
  for (Vec3f& p : bent.positions)
    p = Vec3f(p.y(), std::abs(p.x()) < 0.3f ? p.x() : std::copysign(0.3f, p.x()),
              std::max(0.0f, std::abs(p.x()) - 0.3f));
  const Ground valley(bent);
  std::vector<Vec3d> places;
  for (int i = 0; i <= 40; ++i) {
    const double x = -0.9 + 1.8 * i / 40;
    places.emplace_back(0, std::clamp(x, -0.3, 0.3), std::max(0., std::abs(x) - 0.3));
  }
  EXPECT_FALSE(valley.trace(places, 0.1).closed_curve(Closure::closed).has_value());
}

TEST(ClosedCurve, CarriesPenAndWidthOverTheSeam) {
  CurveTracer tracer(ground().surface, ground().picker, 0.1, StrokeWidth(0.5, {}, {{.pressure = true}}));
  const std::vector<Vec3d> places = arc(0, 2 * pi - 2 * pi / 40, 40);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto pressure = static_cast<float>(i) / 39;
    tracer.add(*ground().picker.closest(places[i].cast<float>(), 1), 0.01 * static_cast<double>(i),
               {pressure});
  }
  const SurfaceCurve curve = *tracer.closed_curve(Closure::closed);
  const double seam = curve.length(), last = seam * 39 / 40;
  EXPECT_NEAR(pen_at(curve, last).width, 1, 0.02);
  EXPECT_NEAR(pen_at(curve, (last + seam) / 2).width, 0.75, 0.02);
  EXPECT_NEAR(pen_at(curve, seam - 1e-6).width, 0.5, 1e-3);
  EXPECT_NEAR(pen_at(curve, seam - 1e-6).pen.pressure, 0, 1e-3);
  EXPECT_NEAR(pen_at(curve, seam - 1e-6).speed, pen_at(curve, 0.1).speed, 0.05 * pen_at(curve, 0.1).speed);
}

}  // namespace
}  // namespace burin
