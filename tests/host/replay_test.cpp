#include "sessions.h"
#include "support/shared_data.h"

#include <burin/host/replay.h>

#include <numbers>

namespace burin {
namespace {

using test::error_of;
using test::settings;

RecordedStroke stroke_of(std::vector<Sample> samples) {
  RecordedStroke stroke;
  stroke.brush = "org.burin.groove";
  stroke.radius = 0.1;
  stroke.fields = {.time = true, .pressure = true};
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
  by_hand.fields = {.time = true, .pressure = true};
  test::draw(drawn, by_hand, test::wave());
  test::draw(drawn, by_hand, test::wave(15));
  EXPECT_EQ(result.hash, drawn.result_hash());
  EXPECT_EQ(result.strokes, 2u);
  EXPECT_EQ(result.pieces, 2u);
  EXPECT_EQ(pieces_seen, 2u);
  EXPECT_EQ(result.samples_drawn, 55u);
  EXPECT_EQ(result.samples_off_surface, 0u);
  EXPECT_EQ(result.latencies.size(), 55u);
  EXPECT_GT(result.vertices_changed, 1000u);
  EXPECT_EQ(done, 1);
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
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.undo());
  EXPECT_FALSE(session.undo());
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
  recording.strokes[0].params = {{"depth", 0.1}, {"width", 0.5}};
  Session replayed = test::plane_session(), drawn = test::plane_session();
  StrokeOverrides overrides;
  overrides.radius = 0.2;
  overrides.strength = 0.5;
  overrides.params = {{"depth", 0.3}};
  const ReplayResult result = replay(replayed, recording, overrides);
  StrokeSettings by_hand = settings("org.burin.groove", 0.2);
  by_hand.fields = {.time = true, .pressure = true};
  by_hand.strength = 0.5;
  by_hand.params = {{"depth", 0.3}, {"width", 0.5}};
  test::draw(drawn, by_hand, test::wave());
  EXPECT_EQ(result.hash, drawn.result_hash());
}

TEST(Replay, LeavesTheParametersOfAnotherBrushBehind) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave())};
  recording.strokes[0].params = {{"depth", 0.1}};
  Session session = test::plane_session();
  StrokeOverrides overrides;
  overrides.brush = "org.burin.test.every-input";
  EXPECT_EQ(replay(session, recording, overrides).samples_drawn, 40u);
}

TEST(Replay, NamesTheStrokeThatLacksSomethingBeforeDrawing) {
  Recording recording;
  recording.strokes = {stroke_of(test::wave()), stroke_of(test::wave())};
  recording.strokes[1].brush.reset();
  Session session = test::plane_session();
  EXPECT_EQ(error_of([&] { replay(session, recording); }), "stroke 2 names no brush");
  recording.strokes[1] = recording.strokes[0];
  recording.strokes[1].radius.reset();
  EXPECT_EQ(error_of([&] { replay(session, recording); }), "stroke 2 has no radius");
  EXPECT_FALSE(session.undo());
}

TEST(Replay, StampsScalesWithARealPicture) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/Rock035_height_1024_half_zip.exr");
  Recording recording;
  recording.strokes = {stroke_of(test::wave_on_sphere())};
  StrokeOverrides overrides;
  overrides.brush = "org.burin.scales";
  overrides.params = {{"stamp", path.string()}};
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
