// Tests strokes of dabs, with real brushes.
#include "host/symmetric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace burin {
namespace {

using test::draw;
using test::settings;

StrokeSettings dabs(StrokeSettings settings, double spacing) {
  settings.dab_spacing = spacing;
  return settings;
}

StrokeSettings scales() {
  StrokeSettings scales = settings("org.burin.scales");
  scales.params = {{"stamp", std::string(BURIN_SAMPLES "/stamps/scales.exr")}};
  return scales;
}

StrokeSettings every_input() {
  StrokeSettings every = settings("org.burin.test.every-input");
  every.fields = {.time = true, .pressure = true, .tilt = true, .twist = true};
  every.pressure_width = 0.5;
  return every;
}

/// A square of 101 x 101 vertices, 0.02 apart, around the origin.
TriangleMesh grid() {
  constexpr Index side = 101;
  TriangleMesh mesh;
  for (Index row = 0; row < side; ++row)
    for (Index column = 0; column < side; ++column)
      mesh.positions.emplace_back(0.02f * static_cast<float>(column) - 1, 0.02f * static_cast<float>(row) - 1,
                                  0.0f);
  for (Index row = 0; row + 1 < side; ++row)
    for (Index column = 0; column + 1 < side; ++column) {
      const Index corner = row * side + column;
      mesh.triangles.push_back({corner, corner + 1, corner + side});
      mesh.triangles.push_back({corner + 1, corner + side + 1, corner + side});
    }
  return mesh;
}

std::vector<Sample> straight_line() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 26; ++i) samples.push_back({0.01 * i, Vec3d(-0.6 + 0.05 * i, 0, 0), {}});
  return samples;
}

TEST(Dabs, GrowToWhatIsDrawnAtOnce) {
  for (const StrokeSettings& brush : {settings("org.burin.groove"), scales(), every_input()}) {
    for (const double spacing : {0.25, 1.1}) {
      for (const Accumulate accumulate : {Accumulate::from_base, Accumulate::from_current}) {
        if (accumulate == Accumulate::from_current && brush.brush == "org.burin.test.every-input") continue;
        SCOPED_TRACE(brush.brush);
        StrokeSettings row = dabs(brush, spacing);
        row.accumulate = accumulate;
        Session shown = test::sphere_session(), held = test::sphere_session();
        const test::Snapshot before(shown);
        draw(shown, row, test::wave_on_sphere());
        held.begin_stroke(row);
        for (const Sample& sample : test::wave_on_sphere())
          held.add_sample(sample.position, sample.time, sample.pen, Show::later);
        held.end_stroke();
        EXPECT_FALSE(test::Snapshot(shown) == before);
        EXPECT_EQ(shown.result_hash(), held.result_hash()) << spacing;
        EXPECT_TRUE(shown.undo());
        EXPECT_TRUE(test::Snapshot(shown) == before);
      }
    }
  }
}

TEST(Dabs, AreAsDeepAsAStrokeTheSmootherTheCloser) {
  double least_before = 0;
  for (const double spacing : {1., 0.4, 0.1}) {
    Session session(make_surface(grid()), test::brushes());
    StrokeSettings groove = settings("org.burin.groove", 0.2);
    draw(session, dabs(groove, spacing), straight_line());
    double deepest = 0, least = 1;
    for (const Vec3f& position : session.positions()) {
      deepest = std::max(deepest, double{-position.z()});
      if (position.y() == 0 && std::abs(position.x()) < 0.5f) least = std::min(least, double{-position.z()});
    }
    EXPECT_NEAR(deepest, 0.05, 1e-5) << spacing;
    EXPECT_GT(least, least_before) << spacing;
    least_before = least;
  }
  EXPECT_GT(least_before, 0.0495);
}

TEST(Dabs, ComputeOnlyTheLastOnesWithEverySample) {
  // Text looks at the length of strokes all along, but not of dabs.
  StrokeSettings text = dabs(settings("org.burin.text"), 0.5);
  text.params = {{"align", std::string("middle")}};
  Session session = test::plane_session();
  session.begin_stroke(text);
  std::uint64_t most = 0;
  for (const Sample& sample : test::wave(80)) {
    session.add_sample(sample.position, sample.time, sample.pen);
    most = std::max(most, session.cost().evaluated);
  }
  EXPECT_LT(most, session.chart().size() / 5);
  session.end_stroke();
  EXPECT_LT(session.cost().evaluated, session.chart().size() / 5);
}

/// The paper's Figure 2a.
TEST(Dabs, RepeatThePictureOfAStamp) {
  StrokeSettings stamp = dabs(scales(), 2);
  stamp.radius = 0.13;
  stamp.dab_spacing = 0.26 / 0.13;
  stamp.params["offset_along"] = 0.3;
  Session session(make_surface(grid()), test::brushes());
  draw(session, stamp, straight_line());
  std::map<std::pair<int, int>, float> height;
  for (const Vec3f& place : session.positions())
    height[{static_cast<int>(std::lround(place.x() / 0.02f)),
            static_cast<int>(std::lround(place.y() / 0.02f))}] = place.z();
  float highest = 0, worst = 0;
  std::size_t raised = 0;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      if (x * x + y * y >= 42) continue;  // rims, which may or may not belong
      const float first = height.at({x - 30, y});
      raised += first != 0;
      highest = std::max(highest, std::abs(first));
      for (int dab = 1; dab <= 5; ++dab)
        worst = std::max(worst, std::abs(height.at({x - 30 + 13 * dab, y}) - first));
    }
  }
  EXPECT_GT(raised, 80u);
  EXPECT_GT(highest, 0.01f);
  EXPECT_LE(worst, 1e-3f * highest);
}

std::size_t moved(const Session& session) {
  std::size_t count = 0;
  for (const Vec3f& place : session.positions()) count += place.z() != 0;
  return count;
}

TEST(Dabs, OfAClosedStrokeAreThoseOfAnOpenOne) {
  // Stitches: one to a dab, but without end along a closed stroke.
  const StrokeSettings stitches = dabs(settings("org.burin.stitches", 0.13), 2.1);
  Session session(make_surface(grid()), test::brushes()), open(make_surface(grid()), test::brushes());
  std::vector<Sample> loop;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.105 * i;
    loop.push_back({0.01 * i, Vec3d(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0), {}});
  }
  session.begin_stroke(stitches);
  test::add(session, loop);
  session.end_stroke(Closure::closed);
  ASSERT_TRUE(session.curve().closed);
  draw(open, stitches, {loop.front()});
  const double count = std::round(session.curve().length() / (2.1 * 0.13));
  const auto one = static_cast<double>(moved(open));
  EXPECT_GT(one, 20);
  EXPECT_NEAR(static_cast<double>(moved(session)), count * one, 0.1 * count * one);
}

TEST(Dabs, AreMirroredAcrossThePlane) {
  StrokeSettings mirrored = dabs(settings("org.burin.groove", 0.2), 0.5);
  mirrored.symmetry.mirror_x = true;
  const SymmetryInstance image = symmetry_instances(mirrored.symmetry)[1];
  test::SymmetricSession symmetric(test::octahedral_sphere(48), image);
  draw(symmetric.session, mirrored, test::arc(0.3, 2.2, 0.2));
  EXPECT_GT(symmetric.moved(), 300u);
  EXPECT_LE(symmetric.worst(image), 1e-5);
}

TEST(Clamp, HoldsVerticesWithinARadius) {
  constexpr double radius = 0.1;
  for (const double spacing : {0.0, 0.5}) {
    StrokeSettings high = dabs(settings("org.burin.groove", radius), spacing), clamped = high;
    high.params = clamped.params = {{"depth", -3.0}};
    clamped.clamp_to_radius = true;
    Session free = test::sphere_session(), held = test::sphere_session();
    const std::vector<Vec3f> base = free.surface().positions;
    draw(free, high, test::wave_on_sphere());
    draw(held, clamped, test::wave_on_sphere());
    std::size_t stopped = 0, same = 0;
    for (Index vertex = 0; vertex < base.size(); ++vertex) {
      const Vec3f way = free.positions()[vertex] - base[vertex],
                  moved = held.positions()[vertex] - base[vertex];
      if (way.norm() > radius) {
        ++stopped;
        ASSERT_LT((moved - static_cast<float>(radius) * way.normalized()).norm(), 1e-6);
      } else {
        same += way.norm() > 0;
        ASSERT_EQ(held.positions()[vertex], free.positions()[vertex]);
      }
    }
    EXPECT_GT(stopped, 40u);
    EXPECT_GT(same, 100u);
  }
}

}  // namespace
}  // namespace burin
