// Tests strokes that accumulate on their own result, with real brushes.
#include "host/sessions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace burin {
namespace {

using test::draw;
using test::settings;

StrokeSettings ridge(double height) {
  StrokeSettings ridge = settings("org.burin.groove", 0.2);
  ridge.params = {{"depth", -height}, {"taper", 0.0}};
  ridge.overlap = Overlap::add;
  return ridge;
}

StrokeSettings from_current(StrokeSettings settings) {
  settings.accumulate = Accumulate::from_current;
  return settings;
}

/// Samples that go back and forth along a line this many times.
std::vector<Sample> to_and_fro(int times) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 20 * times; ++i) {
    const double way = i % 40 / 20.;
    samples.push_back({0.01 * i, Vec3d(way <= 1 ? 1.2 * way - 0.6 : 1.8 - 1.2 * way, 0.1, 0), {}});
  }
  return samples;
}

std::vector<Sample> samples_of_an_eight() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 150; ++i) {
    const double angle = 2 * 3.14159265 * i / 150 + 0.8;
    samples.push_back({0.01 * i, Vec3d(0.6 * std::sin(angle), 0.4 * std::sin(2 * angle), 0), {}});
  }
  return samples;
}

TEST(Accumulate, IsTheSumWhereSlopesAreSmall) {
  constexpr double radius = 0.2, height = 0.004;
  for (const int times : {1, 2, 5}) {
    Session session = test::plane_session();
    const std::vector<Vec3f> base = session.surface().positions;
    draw(session, from_current(ridge(height)), to_and_fro(times));
    double worst = 0, highest = 0;
    for (Index vertex = 0; vertex < base.size(); ++vertex) {
      const double x = (base[vertex].y() - 0.1) / radius;
      if (std::abs(base[vertex].x()) > 0.2 || std::abs(x) > 0.99) continue;
      const double expected = times * height * radius * (1 - x * x) * (1 - x * x);
      worst = std::max(worst, std::abs(session.positions()[vertex].z() - expected));
      highest = std::max(highest, expected);
    }
    EXPECT_GT(highest, 0.95 * times * height * radius);
    EXPECT_LT(worst, 1e-3 * highest) << times;
  }
}

TEST(Accumulate, GoesOnAlongTheNormalsOfTheFirstVisit) {
  constexpr double radius = 0.2, height = 0.5;
  Session session = test::plane_session();
  const std::vector<Vec3f> base = session.surface().positions;
  draw(session, from_current(ridge(height)), to_and_fro(2));
  double worst = 0, aside = 0;
  for (Index vertex = 0; vertex < base.size(); ++vertex) {
    const double x = (base[vertex].y() - 0.1) / radius;
    if (std::abs(base[vertex].x()) > 0.2 || std::abs(x) > 0.99) continue;
    const double rim = 1 - x * x, up = height * radius * rim * rim, slope = -4 * height * x * rim;
    const Vec3d normal = Vec3d(0, -slope, 1).normalized();
    const Vec3d expected = base[vertex].cast<double>() + Vec3d(0, 0, up) + up * normal;
    worst = std::max(worst, (session.positions()[vertex].cast<double>() - expected).norm());
    aside = std::max(aside, std::abs(up * normal.y()));
  }
  EXPECT_GT(aside, 0.035);
  EXPECT_LT(worst, 0.02 * 2 * height * radius) << "up to the normals of a mesh of a tenth of the radius";
}

TEST(Accumulate, GrowsToWhatIsDrawnAtOnce) {
  StrokeSettings flatten = settings("org.burin.flatten"), smooth = settings("org.burin.smooth");
  smooth.params = {{"passes", 1.0}};
  for (const StrokeSettings& brush : {ridge(0.3), flatten, smooth}) {
    SCOPED_TRACE(brush.brush);
    for (const auto& samples : {samples_of_an_eight(), to_and_fro(3)}) {
      Session shown = test::plane_session(), held = test::plane_session();
      // Something to flatten and to smooth.
      for (Session* session : {&shown, &held})
        draw(*session, settings("org.burin.groove", 0.3), test::wave());
      const std::uint64_t before = shown.result_hash();
      draw(shown, from_current(brush), samples);
      held.begin_stroke(from_current(brush));
      for (const Sample& sample : samples)
        held.add_sample(sample.position, sample.time, sample.pen, Show::later);
      held.end_stroke();
      EXPECT_NE(shown.result_hash(), before);
      EXPECT_EQ(shown.result_hash(), held.result_hash());
    }
  }
}

TEST(Accumulate, HasNoSeamOnAClosedStroke) {
  std::vector<Sample> loop;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.105 * i;
    loop.push_back({0.01 * i, Vec3d(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0), {}});
  }
  Session current = test::plane_session(), base = test::plane_session();
  const auto close = [&](Session& session, const StrokeSettings& settings) {
    session.begin_stroke(settings);
    test::add(session, loop);
    session.end_stroke(Closure::closed);
    ASSERT_TRUE(session.curve().closed);
  };
  close(current, from_current(ridge(0.5)));
  close(base, ridge(0.5));
  EXPECT_EQ(current.result_hash(), base.result_hash()) << "no visit comes after another";
}

TEST(Accumulate, PilesUpDabs) {
  StrokeSettings row = ridge(0.02);
  row.dab_spacing = 0.5;
  Session current = test::plane_session(), sum = test::plane_session(), one = test::plane_session();
  draw(current, from_current(row), to_and_fro(1));
  draw(sum, row, to_and_fro(1));
  row.overlap = Overlap::max;
  draw(one, row, to_and_fro(1));
  float highest = 0, of_one = 0, worst = 0;
  for (Index vertex = 0; vertex < sum.surface().vertex_count(); ++vertex) {
    highest = std::max(highest, sum.positions()[vertex].z());
    of_one = std::max(of_one, one.positions()[vertex].z());
    worst = std::max(worst, std::abs(current.positions()[vertex].z() - sum.positions()[vertex].z()));
  }
  EXPECT_GT(highest, 1.5f * of_one);
  EXPECT_LT(worst, 0.01f * highest);
  EXPECT_NE(current.result_hash(), sum.result_hash()) << "each along the normals of those before";
}

TEST(Accumulate, RefusesSeveralPasses) {
  Session session = test::plane_session();
  EXPECT_EQ(test::error_of([&] { session.begin_stroke(from_current(settings("org.burin.smooth"))); }),
            "org.burin.smooth: works in several passes, which start from the surface before the stroke");
}

}  // namespace
}  // namespace burin
