// Tests strokes over earlier strokes: what a brush adds to existing relief.
#include <burin/host/replay.h>
#include <burin/stroke/stroke_file.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "moves.h"

namespace burin {
namespace {

using test::settings;

const std::filesystem::path samples_folder = BURIN_SAMPLES;

// A scroll, and a band of scales across it, which are as high as the scroll is deep.
TEST(StrokeOverStroke, IsOnePieceAndAddsToTheRelief) {
  const PolygonMesh cage = read_mesh(samples_folder / "meshes/ewer.obj");
  Session session(make_surface(refine(cage, natural_scheme(cage), 4)), test::brushes());
  const std::vector<Vec3f> bare(session.positions().begin(), session.positions().end());
  double amplitudes = 0;
  for (const auto& [file, depth] :
       {std::pair("strokes/scroll.stroke", 0.25), {"strokes/scale_band.stroke", 0.2}}) {
    const Recording recording = read_strokes(samples_folder / file);
    for (const RecordedStroke& stroke : recording.strokes)
      amplitudes += depth * stroke.settings.complete().radius;
    GivenSettings overrides;
    overrides[&ReplaySettings::show_every] = 0;
    overrides[&StrokeSettings::brush] = "org.burin.scales";
    overrides[&StrokeSettings::params] = {{"stamp", (samples_folder / "stamps/scales.exr").string()}};
    EXPECT_EQ(replay(session, recording, overrides).pieces, 1U) << file;
  }
  double farthest = 0;
  for (std::size_t v = 0; v < bare.size(); ++v)
    farthest = std::max(farthest, static_cast<double>((session.positions()[v] - bare[v]).norm()));
  EXPECT_GT(farthest, amplitudes / 3);
  EXPECT_LE(farthest, 1.5 * amplitudes);
}

constexpr double over_radius = 0.3;

/// The square |x|, |y| <= 1.2 with 20 edges in the radius.
Session square() {
  return Session(make_surface(test::shuffled(test::plane(1.2, over_radius / 20, 4), 5)), test::brushes());
}

/// A pen from above that swings to and fro from a random place.
test::Pens random_pens(std::mt19937& random) {
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.; };
  const double x = 0.4 * share() - 0.2, y = 0.4 * share() - 0.2, along = 2 * std::numbers::pi * share();
  const double bend = 3 * share() - 1.5;
  test::Pens pens;
  for (int i = 0; i < 30; ++i) {
    const double s = -0.6 + 1.2 * i / 29, side = 0.3 * std::sin(bend * 2 * s);
    pens.push_back({{static_cast<float>(x + s * std::cos(along) - side * std::sin(along)),
                     static_cast<float>(y + s * std::sin(along) + side * std::cos(along)), 5},
                    {0, 0, -1}});
  }
  return pens;
}

/// Adds or takes away a round ridge, at most 6 % of the radius high.
StrokeSettings random_settings(std::mt19937& random) {
  StrokeSettings stroke = settings("org.burin.groove", over_radius);
  stroke.params = {{"depth", 0.12 * static_cast<double>(random()) / 4294967296. - 0.06}};
  return stroke;
}

/// Has the session forget what it knows of the surface at the brush's scale.
void touch_with_another_radius(Session& session, const test::Pens& pens) {
  session.begin_stroke(settings("org.burin.groove", 1.02 * over_radius));
  session.add_sample(pens[0], 0, {});
  session.cancel_stroke();
}

// Everything that a session keeps between strokes equals what a new session computes.
TEST(StrokeOverStroke, KeepsNothingStaleBetweenFiftyStrokes) {
  const std::uint32_t seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Session kept = square(), forgetful = square();
  for (int stroke = 0; stroke < 50; ++stroke) {
    const test::Pens pens = random_pens(random);
    const StrokeSettings with = random_settings(random);
    touch_with_another_radius(forgetful, pens);
    test::added(kept, with, pens);
    test::added(forgetful, with, pens);
    ASSERT_EQ(kept.result_hash(), forgetful.result_hash()) << "stroke " << stroke;
    if (stroke % 10 != 9) continue;
    ASSERT_TRUE(kept.undo());
    ASSERT_TRUE(forgetful.undo());
    touch_with_another_radius(forgetful, pens);
    test::added(kept, with, pens);
    test::added(forgetful, with, pens);
    ASSERT_EQ(kept.result_hash(), forgetful.result_hash()) << "after undo";
  }
}

// Kept data stay correct on a surface that ropes as high as the radius have folded, where pieces may
// break off.
TEST(StrokeOverStroke, KeepsNothingStaleOfAFoldedSurface) {
  const std::uint32_t seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Session kept = square(), forgetful = square();
  for (int stroke = 0; stroke < 6; ++stroke) {
    const test::Pens pens = random_pens(random);
    touch_with_another_radius(forgetful, pens);
    for (Session* session : {&kept, &forgetful}) {
      session->begin_stroke(settings(stroke % 3 == 1 ? "org.burin.bead" : "org.burin.rope", over_radius));
      for (std::size_t i = 0; i < pens.size(); ++i)
        session->add_sample(pens[i], static_cast<double>(i) / 240, {}, Show::later);
      session->end_stroke();
    }
    ASSERT_EQ(kept.result_hash(), forgetful.result_hash()) << "stroke " << stroke;
  }
}

/// Draws as a pen does that goes on where it has fallen off an edge; returns in how many pieces.
int drawn_in_pieces(Session& session, const StrokeSettings& with, const test::Pens& pens) {
  int pieces = 0;
  bool down = false;
  session.begin_stroke(with);
  for (std::size_t i = 0; i < pens.size(); ++i) {
    const auto add = [&] { return session.add_sample(pens[i], static_cast<double>(i) / 240, {}).outcome; };
    StrokeEvent::Outcome outcome = add();
    if (outcome != StrokeEvent::Outcome::drawn && down) {
      session.end_stroke();
      session.begin_stroke(with);
      outcome = add();
      down = false;
    }
    if (outcome != StrokeEvent::Outcome::drawn) continue;
    pieces += down ? 0 : 1;
    down = true;
  }
  session.end_stroke();
  return pieces;
}

// Beads that are as high as they are wide, over each other: neither do strokes break into ever more pieces,
// each on top of the one before, nor do vertices fly off.
TEST(StrokeOverStroke, PilesUpReliefAsHighAsTheBrush) {
  const std::uint32_t seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Session session = square();
  int pieces = 0;
  constexpr int strokes = 12;
  for (int stroke = 0; stroke < strokes; ++stroke)
    pieces += drawn_in_pieces(session, settings("org.burin.bead", over_radius), random_pens(random));
  EXPECT_LE(pieces, 18);
  double highest = 0;
  for (const Vec3f& at : session.positions())
    highest = std::max(highest, static_cast<double>(std::abs(at.z())));
  EXPECT_GE(highest, 0.8 * over_radius * strokes / 2);
  EXPECT_LE(highest, 0.81 * over_radius * strokes);
}

// A session that has sculpted for long charts as one that starts with the sculpted surface, but for what
// other clusters of vertices make of it.
TEST(StrokeOverStroke, ChartsAsAFreshSessionAfterFiftyStrokes) {
  const std::uint32_t seed = 6;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Session session = square();
  for (int stroke = 0; stroke < 50; ++stroke) {
    const test::Pens pens = random_pens(random);
    test::added(session, random_settings(random), pens);
  }
  float highest = 0;
  for (const Vec3f& at : session.positions()) highest = std::max(highest, std::abs(at.z()));
  EXPECT_GT(highest, 0.1 * over_radius);
  Session fresh(Surface(session.surface()), test::brushes());
  const test::Pens pens = random_pens(random);
  test::added(session, settings("org.burin.bead", over_radius), pens);
  test::added(fresh, settings("org.burin.bead", over_radius), pens);
  ASSERT_NEAR(session.chart().length, fresh.chart().length, 0.005 * over_radius);
  std::vector<std::size_t> node_of(session.surface().vertex_count(), fresh.chart().size());
  for (std::size_t i = 0; i < fresh.chart().size(); ++i) node_of[fresh.chart().vertex[i]] = i;
  double t_sum = 0, d_sum = 0;
  std::size_t found = 0, missing = 0;
  for (std::size_t i = 0; i < session.chart().size(); ++i) {
    const std::size_t node = node_of[session.chart().vertex[i]];
    if (std::abs(session.chart().d[i]) > 0.95F * static_cast<float>(over_radius)) continue;
    if (node == fresh.chart().size()) {
      ++missing;
      continue;
    }
    t_sum += std::abs(session.chart().t[i] - fresh.chart().t[node]);
    d_sum += static_cast<double>(std::abs(session.chart().d[i] - fresh.chart().d[node]));
    ++found;
  }
  EXPECT_GT(found, 2000U);
  EXPECT_LE(missing, found / 200);
  EXPECT_LE(t_sum / static_cast<double>(found), 0.005 * over_radius);
  EXPECT_LE(d_sum / static_cast<double>(found), 0.005 * over_radius);
}

}  // namespace
}  // namespace burin
