#include "sessions.h"
#include "support/shared_data.h"

#include <burin/host/replay.h>

#include <numbers>
#include <set>

namespace burin {
namespace {

using test::error_of;
using test::settings;

RecordedStroke stroke_of(std::vector<Sample> samples) {
  RecordedStroke stroke;
  stroke.settings[&StrokeSettings::brush] = "org.burin.groove";
  stroke.settings[&StrokeSettings::radius] = 0.1;
  stroke.fields = {.time = true, .pressure = true, .tilt = true};
  stroke.samples = std::move(samples);
  return stroke;
}

/// Looks down on the plane [-1, 1]^2, 100 pixels a unit, parallel rays: y grows downwards.
Camera camera_above() {
  Camera camera;
  camera.view(2, 3) = -5;
  camera.projection(2, 2) = -0.1;
  camera.width = camera.height = 200;
  return camera;
}

Recording on_screen(std::vector<Sample> samples) {
  Recording recording;
  recording.space = StrokeSpace::screen;
  recording.camera = camera_above();
  for (Sample& sample : samples)
    sample.position = Vec3d(100 + 100 * sample.position.x(), 100 - 100 * sample.position.y(), 0);
  recording.strokes = {stroke_of(std::move(samples))};
  return recording;
}

TEST(Replay, IsWhatTheSessionDraws) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave()), stroke_of(test::wave(15))};
  Session replayed = test::plane_session(), drawn = test::plane_session();
  std::size_t pieces_seen = 0;
  double done = 0;
  const ReplayResult result = replay(replayed, recording, {},
                                     {[&](std::string_view, double share) {
                                        EXPECT_GT(share, done);
                                        done = share;
                                      },
                                      [&](const Session& session) {
                                        ++pieces_seen;
                                        EXPECT_GT(session.chart().size(), 100u);
                                      }});
  StrokeSettings by_hand = settings("org.burin.groove", 0.1);
  by_hand.fields = {.time = true, .pressure = true, .tilt = true};
  test::draw(drawn, by_hand, test::wave());
  test::draw(drawn, by_hand, test::wave(15));
  EXPECT_EQ(result.hash, drawn.result_hash());
  EXPECT_EQ(result.strokes, 2u);
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(pieces_seen, 2u);
  EXPECT_EQ(result.samples_drawn, 55u);
  EXPECT_EQ(result.samples_off_surface, 0u);
  EXPECT_EQ(result.latencies.size(), 55u);
  ASSERT_EQ(result.costs.size(), 55u);
  for (std::size_t i = 0; i < 55; ++i) {
    EXPECT_LE(result.costs[i].total(), result.latencies[i]);
    EXPECT_GT(result.costs[i].total(), 0);
    EXPECT_GT(result.costs[i].moved, 0u);
  }
  ASSERT_EQ(result.end_costs.size(), 2u);
  for (const EventCost& cost : result.end_costs)
    EXPECT_GT(cost.seconds[static_cast<std::size_t>(Stage::record)], 0);
  EXPECT_EQ(result.end_latencies.size(), 2u);
  EXPECT_GT(result.vertices_changed, 1000u);
  EXPECT_EQ(done, 1);
}

TEST(Replay, TellsTheSamplesOfAPacketApart) {
  Recording even, packets;
  even.strokes = packets.strokes = {stroke_of(test::wave(41))};
  const double interval = even.strokes[0].samples[1].time - even.strokes[0].samples[0].time;
  for (int i = 0; i < 41; ++i) {
    even.strokes[0].samples[i].time = i * interval;
    packets.strokes[0].samples[i].time = (i + 3) / 4 * 4 * interval;
  }
  GivenSettings fast;
  fast[&StrokeSettings::dynamics] = {{"strength", PenSource::speed, {0, 0, 100, 1}}};
  Session at_even = test::plane_session(), in_packets = test::plane_session();
  replay(at_even, even, fast);
  replay(in_packets, packets, fast);
  double most = 0;
  for (Index vertex = 0; vertex < at_even.surface().vertex_count(); ++vertex)
    most = std::max<double>(most, (at_even.positions()[vertex] - in_packets.positions()[vertex]).norm());
  EXPECT_LT(most, 1e-6);
}

TEST(Replay, TakesAStandingClockForNone) {
  Recording standing, without;
  standing.strokes = without.strokes = {stroke_of(test::wave())};
  for (Sample& sample : standing.strokes[0].samples) sample.time = 7;
  without.strokes[0].fields.time = false;
  GivenSettings fast;
  fast[&StrokeSettings::dynamics] = {{"strength", PenSource::speed, {0, 0, 100, 1}}};
  Session neutral = test::plane_session(), session = test::plane_session();
  EXPECT_EQ(replay(neutral, without, fast).standing_clocks, 0u);
  const ReplayResult result = replay(session, standing, fast);
  EXPECT_EQ(result.standing_clocks, 1u);
  EXPECT_EQ(result.hash, neutral.result_hash());
}

TEST(Replay, IsTheSameHoweverManySamplesAreShown) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave(40))};
  Session each = test::plane_session();
  const ReplayResult every = replay(each, recording);
  EXPECT_EQ(every.latencies.size(), 40u);
  for (const std::size_t show_every : {0u, 3u, 40u}) {
    Session session = test::plane_session();
    GivenSettings overrides;
    overrides[&ReplaySettings::show_every] = show_every;
    const ReplayResult result = replay(session, recording, overrides);
    EXPECT_EQ(result.hash, every.hash) << show_every;
    EXPECT_EQ(result.samples_drawn, 40u);
    EXPECT_EQ(result.latencies.size(), show_every == 0 ? 0u : 40 / show_every);
    EXPECT_EQ(result.costs.size(), result.latencies.size());
    EXPECT_EQ(result.end_costs.size(), 1u);
    if (show_every == 0) {
      EXPECT_GT(result.end_costs[0].settled, 0u) << "all is done at the end";
    }
  }
}

TEST(Replay, PicksScreenSamplesThroughTheCamera) {
  Session object_space = test::plane_session(), screen_space = test::plane_session();
  Recording recording;
  recording.strokes = {stroke_of(test::wave())};
  replay(object_space, recording);
  const ReplayResult result = replay(screen_space, on_screen(test::wave()));
  EXPECT_EQ(result.samples_drawn, 40u);
  double farthest = 0;
  for (Index vertex = 0; vertex < object_space.surface().vertex_count(); ++vertex)
    farthest = std::max<double>(farthest,
                                (object_space.positions()[vertex] - screen_space.positions()[vertex]).norm());
  EXPECT_LT(farthest, 1e-4);
}

TEST(Replay, BreaksStrokesWhereThePenLeavesTheSurface) {
  std::vector<Sample> samples;
  for (int i = 0; i < 61; ++i) {
    Sample sample;
    sample.time = 0.01 * i;
    // Out over the edge at x = 1 and back, half way.
    sample.position = Vec3d(0.7 + 0.6 * std::sin(std::numbers::pi * i / 60), 0.01 * i, 0);
    samples.push_back(sample);
  }
  Session session = test::plane_session();
  std::vector<double> lengths;
  const ReplayResult result = replay(session, on_screen(samples), {},
                                     {{}, [&](const Session& s) { lengths.push_back(s.curve().length()); }});
  EXPECT_EQ(result.strokes, 1u);
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(result.samples_drawn + result.samples_off_surface, 61u);
  EXPECT_GT(result.samples_off_surface, 30u);
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_NEAR(lengths[0], lengths[1], 0.02);
  EXPECT_TRUE(session.undo()) << "all pieces at once";
  EXPECT_FALSE(session.undo());
}

/// A straight groove of depth 0.05 over the plane, of which some samples are raised off the surface.
double deepest_without(const std::set<int>& raised, const GivenSettings& overrides = {}) {
  std::vector<Sample> samples;
  for (int i = 0; i < 81; ++i)
    samples.push_back({0.01 * i, Vec3d(0.015 * i - 0.6, 0, raised.contains(i) ? 0.5 : 0), {}});
  Recording recording;
  recording.strokes = {stroke_of(samples)};
  recording.strokes[0].settings[&StrokeSettings::params] = {{"depth", 0.5}, {"taper", 0.0}};
  Session session = test::plane_session();
  EXPECT_EQ(replay(session, recording, overrides).pieces, raised.empty() ? 1u : 2u);
  double deepest = 0;
  for (const Vec3f& position : session.positions()) deepest = std::max(deepest, double{-position.z()});
  return deepest;
}

TEST(Replay, StartsAllPiecesFromTheSurfaceBeforeTheStroke) {
  EXPECT_NEAR(deepest_without({}), 0.05, 1e-4);
  EXPECT_NEAR(deepest_without({40}), 0.05, 1e-4);
  EXPECT_NEAR(deepest_without({39, 40, 41}), 0.05, 1e-4);
  GivenSettings added;
  added[&StrokeSettings::overlap] = Overlap::add;
  EXPECT_GT(deepest_without({40}, added), 0.08) << "caps that overlap add up where sheets do";
}

TEST(Replay, BreaksStrokesAcrossAGap) {
  TriangleMesh two = test::plane(1, 0.02, 4);
  const TriangleMesh other = test::plane(1, 0.02, 8);
  const auto offset = static_cast<Index>(two.positions.size());
  for (const Vec3f& position : other.positions) two.positions.push_back(position + Vec3f(4, 0, 0));
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  Session session(make_surface(two), test::brushes());
  Recording recording;
  std::vector<Sample> samples;
  for (const double x : {0.0, 0.3, 0.6, 3.6, 3.9, 4.2}) samples.push_back({x, Vec3d(x, 0, 0), {}});
  recording.strokes = {stroke_of(samples)};
  const ReplayResult result = replay(session, recording);
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(result.samples_drawn, 6u);
  EXPECT_NEAR(session.curve().length(), 0.6, 1e-5);
}

TEST(Replay, TakesOverridesFirst) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave())};
  recording.strokes[0].settings[&StrokeSettings::params] = {{"depth", 0.1}, {"width", 0.5}};
  Session replayed = test::plane_session(), drawn = test::plane_session();
  GivenSettings overrides;
  overrides[&StrokeSettings::radius] = 0.2;
  overrides[&StrokeSettings::strength] = 0.5;
  overrides[&StrokeSettings::params] = {{"depth", 0.3}};
  const ReplayResult result = replay(replayed, recording, overrides);
  StrokeSettings by_hand = settings("org.burin.groove", 0.2);
  by_hand.fields = {.time = true, .pressure = true, .tilt = true};
  by_hand.strength = 0.5;
  by_hand.params = {{"depth", 0.3}, {"width", 0.5}};
  test::draw(drawn, by_hand, test::wave());
  EXPECT_EQ(result.hash, drawn.result_hash());
}

TEST(Replay, FollowsReliefAsRecordedOrTold) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave_on_sphere())};
  const auto replayed = [&](std::optional<double> told) {
    Session session = test::sphere_session();
    GivenSettings overrides;
    if (told) overrides[&StrokeSettings::follow] = *told;
    return replay(session, recording, overrides).hash;
  };
  const auto drawn = [](double follow) {
    Session session = test::sphere_session();
    StrokeSettings by_hand = settings("org.burin.groove", 0.2);
    by_hand.fields = {.time = true, .pressure = true, .tilt = true};
    by_hand.follow = follow;
    test::draw(session, by_hand, test::wave_on_sphere());
    return session.result_hash();
  };
  recording.strokes[0].settings[&StrokeSettings::radius] = 0.2;
  EXPECT_NE(drawn(0), drawn(1));
  EXPECT_EQ(replayed({}), drawn(0));
  EXPECT_EQ(replayed(0.5), drawn(0.5));
  recording.strokes[0].settings[&StrokeSettings::follow] = 1;
  EXPECT_EQ(replayed({}), drawn(1));
  EXPECT_EQ(replayed(0), drawn(0));
}

TEST(Replay, LeavesTheParametersOfAnotherBrushBehind) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave())};
  recording.strokes[0].settings[&StrokeSettings::params] = {{"depth", 0.1}};
  Session session = test::plane_session();
  GivenSettings overrides;
  overrides[&StrokeSettings::brush] = "org.burin.test.every-input";
  EXPECT_EQ(replay(session, recording, overrides).samples_drawn, 40u);
}

TEST(Replay, NamesTheStrokeThatLacksSomethingBeforeDrawing) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave()), stroke_of(test::wave())};
  recording.strokes[1].settings.erase(&StrokeSettings::brush);
  Session session = test::plane_session();
  EXPECT_EQ(error_of([&] { replay(session, recording); }), "stroke 2 names no brush");
  recording.strokes[1] = recording.strokes[0];
  recording.strokes[1].settings.erase(&StrokeSettings::radius);
  EXPECT_EQ(error_of([&] { replay(session, recording); }), "stroke 2 has no radius");
  EXPECT_FALSE(session.undo());
}

/// A circle around the z axis with this radius; the last sample is one step before the first.
std::vector<Sample> loop(double radius, int count = 60, double turns = 1) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / count;
    samples.push_back({0.01 * i, radius * Vec3d(std::cos(angle), std::sin(angle), 0), {}});
  }
  return samples;
}

TEST(Replay, ClosesWhatIsMarkedClosedUnlessToldOtherwise) {
  struct Case {
    bool marked;
    std::optional<Closure> told;
    double turns;
    bool closed;
    std::size_t left_open;
  };
  const Case cases[] = {{true, {}, 1, true, 0},
                        {false, {}, 1, false, 0},
                        {true, Closure::open, 1, false, 0},
                        {false, Closure::closed, 1, true, 0},
                        {false, Closure::closed, 0.6, true, 0},
                        {false, Closure::automatic, 1, true, 0},
                        {true, Closure::automatic, 0.6, false, 0}};
  for (const auto& [marked, told, turns, closed, left_open] : cases) {
    Recording recording;
    recording.strokes = {stroke_of(loop(0.6, 120, turns))};
    if (marked) recording.strokes[0].settings[&ReplaySettings::closure] = Closure::closed;
    Session session = test::plane_session();
    GivenSettings overrides;
    if (told) overrides[&ReplaySettings::closure] = *told;
    EXPECT_EQ(replay(session, recording, overrides).left_open, left_open);
    EXPECT_EQ(session.curve().closed, closed);
    EXPECT_EQ(session.chart().closed, closed);
    if (turns == 1 && closed) {
      EXPECT_NEAR(session.chart().length, 2 * std::numbers::pi * 0.6, 1e-3);
    }
  }
}

TEST(Replay, LeavesAClosedStrokeOpenThatBreaks) {
  std::vector<Sample> samples = loop(0.6);
  for (Sample& sample : samples) sample.position.x() = 0.6 - sample.position.x();  // over the edge at x = 1
  Recording recording = on_screen(samples);
  recording.strokes[0].settings[&ReplaySettings::closure] = Closure::closed;
  Session session = test::plane_session();
  std::size_t closed = 0;
  const ReplayObserver watch{{}, [&](const Session& drawn) { closed += drawn.curve().closed; }};
  const ReplayResult result = replay(session, recording, {}, watch);
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(result.left_open, 1u);
  EXPECT_EQ(closed, 0u);
  recording.strokes[0].samples.resize(1);
  recording.strokes[0].samples[0].position = Vec3d(100, 100, 0);
  EXPECT_EQ(replay(session, recording).left_open, 1u) << "one sample is no loop";
}

TEST(Replay, NarrowsTheStrokeWithThePressure) {
  std::vector<Sample> line;
  for (int i = 0; i <= 50; ++i)
    line.push_back(
        {0.01 * i, Vec3d(-0.7 + 1.4 * i / 50, 0, 0), {.pressure = 1 - static_cast<float>(i) / 50}});
  GivenSettings overrides;
  overrides[&StrokeSettings::pressure_width] = 0.75;
  Recording recording;
  for (const bool has_pressure : {true, false}) {
    recording.strokes = {stroke_of(has_pressure ? line : test::without_pen(line))};
    recording.strokes[0].settings[&StrokeSettings::params] = {{"taper", 0.0}, {"depth", -0.5}};
    recording.strokes[0].fields.pressure = has_pressure;
    Session session = test::plane_session();
    replay(session, recording, overrides);
    const Chart& chart = session.chart();
    double widest_at_end = 0, worst = 0;
    for (std::size_t i = 0; i < chart.size(); ++i) {
      if (chart.t[i] < 0 || chart.t[i] > 1.4) continue;
      const double half_width = has_pressure ? 0.1 * (1 - 0.75 * chart.t[i] / 1.4) : 0.1;
      const double x = std::min(1., std::abs(chart.d[i]) / half_width);
      const double expected = 0.5 * half_width * (1 - x * x) * (1 - x * x);
      worst = std::max(worst, std::abs(session.positions()[chart.vertex[i]].z() - expected));
      if (chart.t[i] > 1) widest_at_end = std::max<double>(widest_at_end, std::abs(chart.d[i]));
    }
    EXPECT_LT(worst, 1e-4);
    EXPECT_NEAR(widest_at_end, has_pressure ? 0.046 : 0.1, 0.008);
  }
  overrides[&StrokeSettings::pressure_width] = 1.5;
  Session session = test::plane_session();
  EXPECT_EQ(error_of([&] { replay(session, recording, overrides); }),
            "stroke 1: a stroke's pressure width must be from 0 to 1, not 1.5");
}

/// Heights of the plane after scales went around a loop that began `first` samples later, 60 around.
std::vector<double> scales_around(int first, bool closed) {
  Recording recording;
  std::vector<Sample> samples = loop(0.6), places = samples;
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].position = places[(i + static_cast<std::size_t>(first)) % places.size()].position;
  recording.strokes = {stroke_of(samples)};
  recording.strokes[0].settings[&ReplaySettings::closure] = closed ? Closure::closed : Closure::open;
  GivenSettings overrides;
  overrides[&StrokeSettings::brush] = "org.burin.scales";
  overrides[&StrokeSettings::radius] = 0.15;
  // Twelve tiles of five samples each, were they not rounded to be whole: 11.6.
  overrides[&StrokeSettings::params] = {{"stamp", std::string(BURIN_SAMPLES "/stamps/scales.exr")},
                                        {"tile", 1.3 / 0.6}};
  Session session = test::plane_session();
  replay(session, recording, overrides);
  std::vector<double> heights;
  for (const Vec3f& position : session.positions()) heights.push_back(position.z());
  return heights;
}

TEST(Replay, HasNoSeamInScalesAroundAClosedStroke) {
  // A tile later the loop begins elsewhere with the same tiles: a seam would stay behind.
  for (const bool closed : {true, false}) {
    const std::vector<double> heights = scales_around(0, closed), shifted = scales_around(5, closed);
    const double amplitude = std::ranges::max(heights) - std::ranges::min(heights);
    std::vector<double> differences;
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (heights[i] != 0) differences.push_back(std::abs(heights[i] - shifted[i]) / amplitude);
    ASSERT_GT(differences.size(), 1000u);
    ASSERT_GT(amplitude, 0.01);
    std::ranges::sort(differences);
    const double p99 = differences[differences.size() * 99 / 100];
    if (closed) {
      EXPECT_LT(p99, 1e-4);
    } else {
      EXPECT_GT(p99, 0.1) << "the open stroke ends there";
    }
  }
}

TEST(Replay, StampsScalesWithARealPicture) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/Rock035_height_1024_half_zip.exr");
  Recording recording;
  recording.strokes = {stroke_of(test::wave_on_sphere())};
  GivenSettings overrides;
  overrides[&StrokeSettings::brush] = "org.burin.scales";
  overrides[&StrokeSettings::params] = {{"stamp", path.string()}};
  Session session = test::sphere_session();
  const Surface base = session.surface();
  EXPECT_EQ(replay(session, recording, overrides).samples_drawn, 40u);
  std::size_t moved = 0;
  for (Index vertex = 0; vertex < base.vertex_count(); ++vertex) {
    ASSERT_TRUE(session.positions()[vertex].allFinite());
    moved += session.positions()[vertex] != base.positions[vertex];
  }
  EXPECT_GT(moved, 100u);
}

}  // namespace
}  // namespace burin
