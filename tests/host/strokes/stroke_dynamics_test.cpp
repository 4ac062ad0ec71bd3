// Tests strokes whose radius, strength and parameters are driven by the pen, through the whole session.
#include <burin/base/parallel.h>
#include <burin/host/replay.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "host/one_go.h"

namespace burin {
namespace {

using std::numbers::pi;
using test::draw;
using test::error_of;
using test::settings;

constexpr PenFields all_fields{.time = true, .pressure = true, .tilt = true, .twist = true};

/// A ridge of constant height 0.05 along the middle where nothing drives it, without tapered ends.
StrokeSettings ridge(const std::vector<Dynamic>& dynamics, double radius = 0.1) {
  StrokeSettings ridge = settings("org.burin.groove", radius);
  ridge.params = {{"taper", 0.0}, {"depth", -0.5}};
  ridge.dynamics = dynamics;
  ridge.fields = all_fields;
  return ridge;
}

/// A straight stroke from x = -0.7 to 0.7 in one second, at a constant speed of 1.4.
std::vector<Sample> line(const std::function<Pen(double share)>& pen = [](double) { return Pen(); }) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 70; ++i) samples.push_back({i / 70., Vec3d(-0.7 + 1.4 * i / 70, 0, 0), pen(i / 70.)});
  return samples;
}

/// The groove's round profile.
double profile(double x) { return x < 1 ? (1 - x * x) * (1 - x * x) : 0; }

/// The greatest difference of the plane from half_width(t) * height(t) * profile(d / half_width(t)) over the
/// nodes well within the stroke of line().
double worst_error(
    const Session& session, const std::function<double(double t)>& height,
    const std::function<double(double t)>& half_width = [](double) { return 0.1; }) {
  const Chart& chart = session.chart();
  double worst = 0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double t = chart.t[i], width = half_width(t);
    if (t < 0.05 || t > 1.35) continue;
    ++seen;
    const double expected = 0.5 * width * height(t) * profile(std::abs(double{chart.d[i]}) / width);
    worst = std::max(worst, std::abs(session.positions()[chart.vertex[i]].z() - expected));
  }
  EXPECT_GT(seen, 200u);
  return worst;
}

Session drawn(const StrokeSettings& settings, const std::vector<Sample>& samples) {
  Session session = test::plane_session();
  draw(session, settings, samples);
  return session;
}

Pen pressing(double share) { return {.pressure = static_cast<float>(0.2 + 0.6 * share)}; }

TEST(StrokeDynamics, DrivesDepthByPressureAsToldInClosedForm) {
  const auto pressure = [](double t) { return 0.2 + 0.6 * t / 1.4; };
  for (const char* target : {"strength", "depth"}) {
    const Session session =
        drawn(ridge({{target, PenSource::pressure, {0, 0, 0.5, 1, 1, 1.5}}}), line(pressing));
    EXPECT_LT(worst_error(session, [&](double t) { return std::min(2 * pressure(t), 0.5 + pressure(t)); }),
              2e-5)
        << target;
  }
}

TEST(StrokeDynamics, DrivesTheRadiusTogetherWithThePressureWidth) {
  StrokeSettings both = ridge({{"radius", PenSource::t, {0, 1, 14, 0.3}}});
  both.pressure_width = 0.5;
  const Session session = drawn(both, line(pressing));
  const auto width = [](double t) { return 0.1 * (1 - 0.5 * (0.8 - 0.6 * t / 1.4)) * (1 - 0.7 * t / 1.4); };
  EXPECT_LT(worst_error(
                session, [](double) { return 1; }, width),
            1e-4);
}

TEST(StrokeDynamics, TakesEverySource) {
  const std::vector<double> ramp{0, 0, 10, 10};
  const auto drive = [&](PenSource source, const std::vector<Sample>& samples, std::vector<double> curve) {
    return drawn(ridge({{"strength", source, std::move(curve)}}), samples);
  };
  EXPECT_LT(worst_error(drive(PenSource::time, line(), ramp), [](double t) { return t / 1.4; }), 2e-5);
  EXPECT_LT(worst_error(drive(PenSource::t, line(), {0, 0, 20, 2}), [](double t) { return t; }), 2e-5);
  const auto speed = [](double t) { return 1.4 * (1 - std::exp(-t / 1.4 / 0.04)); };
  EXPECT_LT(worst_error(drive(PenSource::speed, line(), {0, 0, 20, 2}), speed), 5e-4);
  EXPECT_LT(worst_error(drive(PenSource::direction, line(), {-1, 0.5, 1, 1}), [](double) { return 0.75; }),
            2e-5);
  const auto leaning = line([](double share) { return Pen{.tilt_x = -static_cast<float>(share)}; });
  EXPECT_LT(worst_error(drive(PenSource::tilt, leaning, ramp), [](double t) { return t / 1.4; }), 2e-5);
  EXPECT_LT(worst_error(drive(PenSource::tilt_direction, leaning, {0, 1, 3, 2}), [](double) { return 2; }),
            2e-5);
  StrokeSettings random = ridge({{"strength", PenSource::random, ramp}});
  random.seed = 3;
  const TargetDynamics noise(random.dynamics, "strength", {all_fields, 0.1, 3});
  EXPECT_LT(worst_error(drawn(random, line()),
                        [&](double t) {
                          PenAt at;
                          at.t = t;
                          return noise.product(at, 0);
                        }),
            2e-5);
}

TEST(StrokeDynamics, HoldsParametersWithinTheirHardRange) {
  const Session session = drawn(ridge({{"width", PenSource::t, {0, -3, 14, 4}}}), line());
  const auto width = [](double t) { return 0.1 * std::clamp(-3 + 7 * t / 1.4, 0.01, 1.); };
  const Chart& chart = session.chart();
  double worst = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double t = chart.t[i];
    if (t < 0.05 || t > 1.35) continue;
    const double expected = 0.05 * profile(std::abs(double{chart.d[i]}) / width(t));
    worst = std::max(worst, std::abs(session.positions()[chart.vertex[i]].z() - expected));
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(StrokeDynamics, LeavesAloneWhatTheRecordingLacks) {
  StrokeSettings driven = ridge({{"strength", PenSource::pressure, {0, 9}},
                                 {"depth", PenSource::speed, {0, 9}},
                                 {"radius", PenSource::tilt, {0, 0.1}}});
  driven.fields = {};
  const Session session = drawn(driven, line()), plain = drawn(ridge({}), line());
  EXPECT_EQ(session.result_hash(), plain.result_hash());
}

TEST(StrokeDynamics, LeavesTheSurfaceUntouchedAtNoStrength) {
  StrokeSettings none = ridge({{"strength", PenSource::pressure, {0, 2, 1, 3}}});
  none.strength = 0;
  EXPECT_EQ(drawn(none, line(pressing)).result_hash(), test::plane_session().result_hash());
}

const std::vector<Dynamic>& dynamics_of_all() {
  static const std::vector<Dynamic> all{
      {"radius", PenSource::pressure, {0, 0.3, 1, 1}}, {"radius", PenSource::speed, {0, 1, 20, 0.5}},
      {"radius", PenSource::random, {0, 0.7, 1, 1}},   {"strength", PenSource::direction, {-3, 0.5, 3, 1.5}},
      {"strength", PenSource::speed, {0, 0.5, 20, 2}}, {"strength", PenSource::tilt, {0, 0.5, 1, 1}},
      {"strength", PenSource::time, {0, 1, 1, 2}},     {"strength", PenSource::random, {0, 0.5, 1, 1}}};
  return all;
}

/// The wave of a pen that rests after every fourth sample while its pressure goes on changing.
std::vector<Sample> resting_wave() {
  std::vector<Sample> samples;
  for (const Sample& sample : test::wave()) {
    samples.push_back(sample);
    if (samples.size() % 4 != 0) continue;
    samples.push_back(sample);
    samples.back().pen.pressure *= 0.5F;
  }
  samples.push_back(samples.back());
  samples.back().pen.pressure = 0.25F;
  return samples;
}

TEST(StrokeDynamics, GrowsAStrokeToWhatOneEvaluationGives) {
  for (const bool round : {false, true}) {
    StrokeSettings all = test::every_input();
    all.dynamics = dynamics_of_all();
    Session session = round ? test::sphere_session() : test::plane_session();
    const Surface base = session.surface();
    draw(session, all, round ? test::wave_on_sphere() : test::wave());
    EXPECT_EQ(session.surface().positions, test::in_one_go(base, session.curve(), all));
  }
}

TEST(StrokeDynamics, GrowsParametersToWhatOneEvaluationGives) {
  StrokeSettings all = ridge({}, 0.15);  // without tapers nothing but the pen makes nodes stale
  for (Dynamic dynamic : dynamics_of_all()) {
    all.dynamics.push_back({"strength", dynamic.source, dynamic.curve});
    dynamic.target = dynamic.target == "radius" ? "width" : "depth";
    all.dynamics.push_back(dynamic);
  }
  Session session = test::plane_session();
  const Surface base = session.surface();
  draw(session, all, resting_wave());
  EXPECT_EQ(session.surface().positions, test::in_one_go(base, session.curve(), all));
}

std::vector<Sample> loop() {
  std::vector<Sample> samples;
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.0625 * i;
    samples.push_back({0.01 * i,
                       Vec3d(0.5 * std::cos(angle), 0.4 * std::sin(angle), 0),
                       {.pressure = static_cast<float>(0.6 + 0.3 * std::sin(angle))}});
  }
  return samples;
}

TEST(StrokeDynamics, ClosesWithAStroke) {
  StrokeSettings all = test::every_input();
  all.dynamics = dynamics_of_all();
  Session session = test::plane_session();
  const Surface base = session.surface();
  session.begin_stroke(all);
  test::add(session, loop());
  session.end_stroke(Closure::automatic);
  ASSERT_TRUE(session.curve().closed);
  EXPECT_EQ(session.surface().positions, test::in_one_go(base, session.curve(), all));
  const SurfaceCurve& curve = session.curve();
  EXPECT_NEAR(pen_at(curve, curve.length() - 1e-4).width, pen_at(curve, 0).width, 2e-3) << "no seam";
}

TEST(StrokeDynamics, IsTheSameHoweverItIsShownAndOnOneThread) {
  StrokeSettings all = test::every_input();
  all.dynamics = dynamics_of_all();
  const std::uint64_t expected = drawn(all, test::wave()).result_hash();
  for (const std::size_t show_every : {3u, 1000u}) {
    Session held = test::plane_session();
    held.begin_stroke(all);
    std::size_t i = 0;
    for (const Sample& sample : test::wave())
      held.add_sample(sample.position, sample.time, sample.pen,
                      ++i % show_every == 0 ? Show::now : Show::later);
    held.end_stroke();
    EXPECT_EQ(held.result_hash(), expected) << show_every;
  }
  const ThreadLimit one(1);
  EXPECT_EQ(drawn(all, test::wave()).result_hash(), expected);
}

TEST(StrokeDynamics, RefusesWhatDoesNotVary) {
  Session session = test::plane_session();
  const auto complaint = [&](const Dynamic& dynamic) {
    return error_of([&] { session.begin_stroke(ridge({dynamic})); });
  };
  const std::string why =
      ": org.burin.groove has no such thing that varies along a stroke; there are: radius, strength, depth, "
      "width";
  EXPECT_EQ(complaint({"dept", PenSource::t, {0, 1}}), "dynamics of 'dept'" + why);
  EXPECT_EQ(complaint({"taper", PenSource::t, {0, 1}}), "dynamics of 'taper'" + why);
  EXPECT_EQ(complaint({"profile", PenSource::t, {0, 1}}), "dynamics of 'profile'" + why);
  EXPECT_EQ(complaint({"depth", PenSource::t, {0, 1, 0, 2}}),
            "dynamics of 'depth': the x of a dynamic's curve must rise");
  EXPECT_EQ(complaint({"depth", PenSource::pressure, {0}}),
            "dynamics of 'depth': a dynamic's curve must be pairs of numbers x y");
  EXPECT_EQ(session.result_hash(), test::plane_session().result_hash());
  session.begin_stroke(ridge({}));
}

/// One smooth S on the plane, its speed and pressure smooth, recorded so many times a second. `haste` makes
/// the pen go so many times as fast.
std::vector<Sample> recorded(double rate, double haste = 1) {
  std::vector<Sample> samples;
  const double seconds = 3 / haste;
  const int count = static_cast<int>(std::round(rate * seconds));
  for (int i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / count, way = s - std::sin(2 * pi * s) / 20;
    const auto pressure = static_cast<float>(0.55 - 0.4 * std::cos(3 * pi * s));
    samples.push_back(
        {seconds * s, Vec3d(1.4 * way - 0.7, 0.35 * std::sin(5 * way), 0), {.pressure = pressure}});
  }
  return samples;
}

struct FieldDifference {
  double rms, most;  ///< shares of the amplitude, over the vertices that either stroke moves
};

FieldDifference difference(const Session& a, const Session& b) {
  double squares = 0, most = 0, amplitude = 0;
  std::size_t moved = 0;
  for (std::size_t i = 0; i < a.positions().size(); ++i) {
    const double one = a.positions()[i].z(), other = b.positions()[i].z();
    if (one == 0 && other == 0) continue;
    ++moved;
    squares += (one - other) * (one - other);
    most = std::max(most, std::abs(one - other));
    amplitude = std::max(amplitude, std::abs(one));
  }
  EXPECT_GT(moved, 500u);
  EXPECT_GT(amplitude, 0.025);
  return {std::sqrt(squares / static_cast<double>(moved)) / amplitude, most / amplitude};
}

const std::vector<Dynamic> by_pressure{{"radius", PenSource::pressure, {0, 0.3, 1, 1}},
                                       {"strength", PenSource::pressure, {0, 0, 0.5, 0.8, 1, 1}}};
const std::vector<Dynamic> by_speed{{"radius", PenSource::speed, {3, 1, 6, 0.5}},
                                    {"strength", PenSource::speed, {3, 0.5, 6, 1}}};

TEST(StrokeDynamics, DoesNotDependOnTheRateOrTheHasteOfTheRecording) {
  const Session often = drawn(ridge(by_pressure), recorded(240));
  const auto expect_same = [&](const char* what, double rate, double haste) {
    const FieldDifference off = difference(often, drawn(ridge(by_pressure), recorded(rate, haste)));
    std::cout << what << ": RMS " << 100 * off.rms << " %, most " << 100 * off.most << " %\n";
    EXPECT_LT(off.rms, 0.005) << what;
  };
  expect_same("60 Hz", 60, 1);
  expect_same("10 times as fast at 240 Hz", 240, 10);
  expect_same("10 times as fast at 60 Hz", 60, 10);
}

TEST(StrokeDynamics, BySpeedDoesNotDependOnTheRate) {
  const Session often = drawn(ridge(by_speed), recorded(240)), seldom = drawn(ridge(by_speed), recorded(60));
  const FieldDifference off = difference(often, seldom);
  std::cout << "60 Hz: RMS " << 100 * off.rms << " %, most " << 100 * off.most << " %\n";
  EXPECT_LT(off.rms, 0.005);
  const FieldDifference effect = difference(often, drawn(ridge({}), recorded(240)));
  EXPECT_GT(effect.rms, 0.05) << "the speed matters";
}

TEST(Replay, TakesDynamicsFromRecordingAndOverrides) {
  Recording recording;
  recording.strokes.resize(1);
  RecordedStroke& stroke = recording.strokes[0];
  stroke.settings[&StrokeSettings::brush] = "org.burin.groove";
  stroke.settings[&StrokeSettings::radius] = 0.1;
  stroke.settings[&StrokeSettings::params] = {{"taper", 0.0}, {"depth", -0.5}};
  stroke.fields = all_fields;
  stroke.samples = line(pressing);
  stroke.settings[&StrokeSettings::dynamics] = {{"depth", PenSource::t, {0, 1, 14, 2}},
                                                {"strength", PenSource::t, {0, 1, 14, 3}}};
  const auto error = [&](const GivenSettings& overrides, const std::function<double(double)>& height) {
    Session session = test::plane_session();
    replay(session, recording, overrides);
    return worst_error(session, height);
  };
  EXPECT_LT(error({}, [](double t) { return (1 + t / 1.4) * (1 + 2 * t / 1.4); }), 2e-5);
  GivenSettings overrides;
  overrides[&StrokeSettings::dynamics] = {{"strength", PenSource::t, {0, 0.5}}};
  EXPECT_LT(error(overrides, [](double t) { return 0.5 * (1 + t / 1.4); }), 2e-5);
  overrides[&StrokeSettings::brush] = "org.burin.scales";
  overrides[&StrokeSettings::params] = {{"stamp", std::string(BURIN_SAMPLES "/stamps/scales.exr")}};
  stroke.settings[&StrokeSettings::dynamics] = {{"width", PenSource::t, {0, 1}}};
  Session session = test::plane_session();
  replay(session, recording, overrides);  // the width is another brush's
}

TEST(Replay, CalmsSamplesWhenTold) {
  Recording recording;
  recording.strokes.resize(1);
  RecordedStroke& stroke = recording.strokes[0];
  stroke.settings[&StrokeSettings::brush] = "org.burin.groove";
  stroke.settings[&StrokeSettings::radius] = 0.1;
  stroke.fields = all_fields;
  stroke.samples = line(pressing);
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].position.y() = i % 2 == 0 ? 0.01 : -0.01;
  const auto length = [&](const Stabilising& stabilising) {
    Session session = test::plane_session();
    GivenSettings overrides;
    overrides[&ReplaySettings::stabilising] = stabilising;
    replay(session, recording, overrides);
    const Vec3f end = session.curve().points.back().at.position;
    EXPECT_LT((end.cast<double>() - stroke.samples.back().position).norm(), 1e-6);
    return session.curve().length();
  };
  EXPECT_GT(length({}), 1.8);
  EXPECT_LT(length({Stabilising::Kind::string, 0.1}), 1.42);
  EXPECT_LT(length({Stabilising::Kind::exponential, 0.1}), 1.42);
  stroke.fields.time = false;
  EXPECT_EQ(error_of([&] {
              length({Stabilising::Kind::exponential, 0.1});
            }),
            "stroke 1 has no times, which the exponential stabiliser needs");
}

}  // namespace
}  // namespace burin
