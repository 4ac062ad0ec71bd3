// Tests strokes of brushes that move the curve: the stock brush wave, and those of modules/curve_filters.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "host/symmetric.h"

namespace burin {
namespace {

using test::draw;
using test::settings;

constexpr double pi = std::numbers::pi;

StrokeSettings wave_settings(double amplitude, double wavelength, double radius = 0.15) {
  StrokeSettings wave = settings("org.burin.wave", radius);
  wave.params = {{"amplitude", amplitude}, {"wavelength", wavelength}};
  return wave;
}

std::vector<Sample> line(const Vec3d& from, const Vec3d& to, int count = 40) {
  std::vector<Sample> samples;
  for (int i = 0; i <= count; ++i) samples.push_back({0.01 * i, from + (to - from) * i / count, {}});
  return samples;
}

std::vector<Sample> circle(double radius, int count = 80) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    samples.push_back({0.01 * i, Vec3d(radius * std::cos(angle), radius * std::sin(angle), 0), {}});
  }
  return samples;
}

TEST(CurveFilter, LaysTheWaveAlongASine) {
  for (const double follow : {0., 1.}) {
    Session session = test::plane_session();
    StrokeSettings wave = wave_settings(1, 4);
    wave.follow = follow;
    draw(session, wave, line({-0.7, 0, 0}, {0.7, 0, 0}));
    double worst = 0;
    for (const CurvePoint& point : session.curve().points) {
      const Vec3d place = point.at.position.cast<double>();
      worst = std::max(worst, std::abs(place.y() - 0.15 * std::sin(2 * pi * (place.x() + 0.7) / 0.6)));
    }
    EXPECT_LT(worst, 3e-4 * 0.15) << follow;
    // The bead is as high as it should be all along the sine, and nowhere else.
    double highest = 0, beside = 0;
    for (const Vec3f& place : session.positions()) {
      const double sine = 0.15 * std::sin(2 * pi * (static_cast<double>(place.x()) + 0.7) / 0.6);
      const double off = std::abs(static_cast<double>(place.y()) - sine);
      if (std::abs(place.x()) < 0.6F && off < 0.002) highest = std::max(highest, std::abs(place.z() - 0.03));
      if (off > 0.15) beside = std::max(beside, std::abs(static_cast<double>(place.z())));
    }
    EXPECT_LT(highest, 1.5e-3) << follow;
    EXPECT_EQ(beside, 0) << follow;
  }
}

std::vector<StrokeSettings> moving_brushes() {
  StrokeSettings dynamic = wave_settings(0.6, 3);
  dynamic.fields = {.time = true, .pressure = true, .tilt = true};
  dynamic.pressure_width = 0.5;
  dynamic.dynamics = {{"height", PenSource::speed, {0, 0.5, 4, 1}}};
  StrokeSettings joined = wave_settings(0.6, 3);
  joined.join = Join::smooth;
  StrokeSettings dabs = wave_settings(0.6, 3);
  dabs.dab_spacing = 0.5;
  return {wave_settings(0.6, 3),          dynamic, joined, dabs, settings("org.burin.test.smoothed-curve"),
          settings("org.burin.test.arch")};
}

TEST(CurveFilter, GivesTheSameBitsHoweverSamplesAreShown) {
  for (const StrokeSettings& brush : moving_brushes()) {
    for (const Closure closure : {Closure::open, Closure::closed}) {
      SCOPED_TRACE(brush.brush);
      std::vector<std::uint64_t> hashes;
      for (const int every : {1, 3, 1000}) {
        Session session = test::plane_session();
        const test::Snapshot before(session);
        session.begin_stroke(brush);
        const std::vector<Sample> samples = closure == Closure::closed ? circle(0.5) : test::wave();
        for (std::size_t i = 0; i < samples.size(); ++i)
          session.add_sample(samples[i].position, samples[i].time,
                             brush.fields.pressure ? samples[i].pen : Pen{},
                             (i + 1) % static_cast<std::size_t>(every) == 0 ? Show::now : Show::later);
        session.end_stroke(closure);
        EXPECT_EQ(session.curve().closed, closure == Closure::closed);
        EXPECT_FALSE(test::Snapshot(session) == before);
        hashes.push_back(session.result_hash());
        EXPECT_TRUE(session.undo());
        EXPECT_TRUE(test::Snapshot(session) == before);
      }
      EXPECT_EQ(hashes[1], hashes[0]);
      EXPECT_EQ(hashes[2], hashes[0]);
    }
  }
}

TEST(CurveFilter, LaysAWholeNumberOfWavesAroundAClosedStroke) {
  Session session = test::plane_session();
  session.begin_stroke(wave_settings(0.4, 4.3));
  test::add(session, circle(0.5));
  session.end_stroke(Closure::closed);
  ASSERT_TRUE(session.curve().closed);
  // pi / (4.3 * 0.15) = 4.87
  for (const CurvePoint& point : session.curve().points) {
    const Vec3d place = point.at.position.cast<double>();
    const double angle = std::atan2(place.y(), place.x());
    EXPECT_NEAR(place.norm(), 0.5 - 0.06 * std::sin(5 * angle), 1e-3);
  }
}

TEST(CurveFilter, MovesACurveThatItMustKnowWholeAtTheEnd) {
  Session session = test::plane_session();
  session.begin_stroke(settings("org.burin.test.arch"));
  test::add(session, line({-0.5, 0, 0}, {0.5, 0, 0}));
  for (const CurvePoint& point : session.curve().points)
    EXPECT_NEAR(point.at.position.y(), 0, 1e-6) << "as drawn until then";
  EXPECT_GT(session.chart().size(), 500U);
  session.end_stroke();
  for (const CurvePoint& point : session.curve().points) {
    const double s = static_cast<double>(point.at.position.x()) + 0.5;
    EXPECT_NEAR(point.at.position.y(), 0.4 * s * (1 - s), 1e-4);
  }
  for (const Vec3f& place : session.positions())
    ASSERT_TRUE(place.y() > -0.16F || place.z() == 0) << "nothing is left of the drawn curve";
}

TEST(CurveFilter, KeepsSymmetry) {
  const SymmetryInstance mirrored = symmetry_instances({.mirror_x = true})[1];
  for (const StrokeSettings& brush : {wave_settings(0.6, 3), settings("org.burin.test.smoothed-curve")}) {
    test::SymmetricSession symmetric(test::octahedral_sphere(40), mirrored);
    StrokeSettings both = brush;
    both.symmetry.mirror_x = true;
    std::vector<Sample> samples;
    for (int i = 0; i <= 30; ++i)
      samples.push_back({0.01 * i, Vec3d(0.5 + 0.01 * i, 0.3 - 0.02 * i, 0.6).normalized(), {}});
    draw(symmetric.session, both, samples);
    EXPECT_GT(symmetric.moved(), 80U);
    EXPECT_LT(symmetric.worst(mirrored), 1e-5 * 0.15);
  }
}

TEST(CurveFilter, MovesImagesOfASurfaceThatIsNotSymmetricToTheirOwnSide) {
  Session session = test::plane_session();
  StrokeSettings both = wave_settings(0.6, 3);
  both.symmetry.mirror_y = true;
  draw(session, both, line({-0.7, 0.5, 0}, {0.7, 0.5, 0}));
  double worst = 0;
  for (const Vec3f& place : session.positions()) {
    const double sine = 0.5 + 0.09 * std::sin(2 * pi * (static_cast<double>(place.x()) + 0.7) / 0.45);
    if (std::abs(place.x()) > 0.6F) continue;
    const bool on_one = std::abs(static_cast<double>(place.y()) - sine) < 0.002;
    const bool on_other = std::abs(static_cast<double>(place.y()) + sine) < 0.002;
    if (on_one || on_other) worst = std::max(worst, std::abs(static_cast<double>(place.z()) - 0.03));
  }
  EXPECT_LT(worst, 1.5e-3);
}

TEST(CurveFilter, StopsTheWaveWhereTheSurfaceEnds) {
  for (const double follow : {0., 1.}) {
    Session session = test::plane_session();
    StrokeSettings wave = wave_settings(1, 4);
    wave.follow = follow;
    draw(session, wave, line({-0.7, 0.92, 0}, {0.7, 0.92, 0}));
    double highest = 0, lowest = 1;
    for (const CurvePoint& point : session.curve().points) {
      highest = std::max(highest, static_cast<double>(point.at.position.y()));
      lowest = std::min(lowest, static_cast<double>(point.at.position.y()));
    }
    std::cout << "the curve ends " << (highest - 1) / 0.15 << " radii beyond the border\n";
    EXPECT_NEAR(highest, 1, follow > 0 ? 1e-6 : 0.01 * 0.15);
    EXPECT_NEAR(lowest, 0.77, 1e-4);
  }
}

TEST(CurveFilter, MovesEachPieceByItself) {
  Session session = test::plane_session();
  session.begin_stroke(wave_settings(0.6, 3));
  test::add(session, line({-0.7, 0.4, 0}, {0.7, 0.4, 0}));
  session.end_piece();
  EXPECT_NEAR(session.curve().points.front().at.position.y(), 0.4, 1e-6);
  double time = 1;
  for (const Sample& sample : line({0.7, -0.4, 0}, {-0.7, -0.4, 0}))
    session.add_sample(sample.position, time += 0.01, {});
  session.end_stroke();
  EXPECT_NEAR(session.curve().points.front().at.position.y(), -0.4, 1e-6)
      << "its own wave starts at its start";
  EXPECT_TRUE(session.undo());
  EXPECT_FALSE(session.undo());
}

TEST(CurveFilter, NamesTheBrushWhoseOffsetsAreNone) {
  const auto refusal = [](const char* brush) {
    Session session = test::plane_session();
    const test::Snapshot before(session);
    const std::string line = test::error_of([&] { draw(session, settings(brush), test::wave()); });
    EXPECT_TRUE(test::Snapshot(session) == before);
    return line;
  };
  EXPECT_EQ(refusal("org.burin.test.no-reach"),
            "org.burin.test.no-reach: moves curves by what is 0 behind and -1 ahead");
  EXPECT_EQ(refusal("org.burin.test.refuses-curves"), "org.burin.test.refuses-curves: not this curve");
  EXPECT_EQ(refusal("org.burin.test.no-number"),
            "org.burin.test.no-number: moves the curve by (nan, 0) at t = 0");
}

}  // namespace
}  // namespace burin
