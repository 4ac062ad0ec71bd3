#include <burin/base/parallel.h>
#include <burin/surface/geometry/normals.h>

#include <algorithm>
#include <limits>
#include <set>

#include "one_go.h"
#include "support/point_shapes.h"

namespace burin {
namespace {

using test::add;
using test::draw;
using test::error_of;
using test::every_input;
using test::settings;
using test::Snapshot;

void expect_normals_of_positions(const Session& session) {
  for (Index vertex = 0; vertex < session.surface().vertex_count(); ++vertex)
    ASSERT_EQ(session.normals()[vertex], vertex_normal(session.surface(), session.positions(), vertex))
        << vertex;
}

TEST(Session, GrowsAStrokeToWhatOneEvaluationGives) {
  for (const bool round : {false, true}) {
    Session session = round ? test::sphere_session() : test::plane_session();
    const Surface base = session.surface();
    draw(session, every_input(), round ? test::wave_on_sphere() : test::wave());
    EXPECT_GT(session.chart().size(), 500u);
    EXPECT_EQ(session.surface().positions, test::in_one_go(base, session.curve(), every_input()));
    EXPECT_TRUE(std::equal(session.positions().begin(), session.positions().end(),
                           session.surface().positions.begin()));
    expect_normals_of_positions(session);
  }
}

TEST(Session, GrowsAStrokeWhoseWidthFollowsThePen) {
  StrokeSettings narrowing = every_input();
  narrowing.pressure_width = 0.8;
  Session session = test::plane_session();
  const Surface base = session.surface();
  draw(session, narrowing, test::wave());
  EXPECT_EQ(session.surface().positions, test::in_one_go(base, session.curve(), narrowing));
  const std::uint64_t hash = session.result_hash();
  narrowing.fields = {};
  session.undo();
  draw(session, narrowing, test::without_pen(test::wave()));
  EXPECT_EQ(session.curve().points.back().width, 1) << "no pressure, full width";
  EXPECT_NE(session.result_hash(), hash);
}

TEST(Session, RefusesAPenThatReportsWhatItsFieldsDoNotSay) {
  Session session = test::plane_session();
  const Snapshot untouched(session);
  StrokeSettings mouse = every_input();
  mouse.fields = {.time = true};
  const auto refusal = [&](const Pen& pen) {
    session.begin_stroke(mouse);
    return test::error_of([&] {
      session.add_sample(Vec3d(0, 0, 0), 0, {});
      session.add_sample(Vec3d(0.1, 0, 0), 0.1, pen);
    });
  };
  EXPECT_EQ(refusal({.pressure = 0.5F}),
            "the pen's pressure is 0.5, but StrokeSettings::fields says that it reports none");
  EXPECT_EQ(refusal({.tilt_y = 0.25F}),
            "the pen's tilt is 0.25, but StrokeSettings::fields says that it reports none");
  EXPECT_EQ(refusal({.twist = 1}),
            "the pen's twist is 1, but StrokeSettings::fields says that it reports none");
  EXPECT_EQ(Snapshot(session), untouched);
  EXPECT_EQ(refusal({}), "none");
}

TEST(Session, ClosesAStrokeAtItsEnd) {
  Session session = test::plane_session();
  const Surface base = session.surface();
  const Snapshot untouched(session);
  session.begin_stroke(every_input());
  std::vector<Sample> loop(100);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = 0.0625 * static_cast<double>(i);
    loop[i].time = 0.01 * static_cast<double>(i);
    loop[i].position = Vec3d(0.5 * std::cos(angle), 0.4 * std::sin(angle), 0);
  }
  add(session, loop);
  const Snapshot open(session);
  const auto changed = session.end_stroke(Closure::automatic);
  const std::set<Index> reported(changed.begin(), changed.end());
  ASSERT_TRUE(session.curve().closed);
  EXPECT_EQ(session.surface().positions, test::in_one_go(base, session.curve(), every_input()));
  expect_normals_of_positions(session);
  for (Index vertex = 0; vertex < base.vertex_count(); ++vertex) {
    const bool same = session.positions()[vertex] == open.shown_positions[vertex] &&
                      session.normals()[vertex] == open.shown_normals[vertex];
    ASSERT_TRUE(same || reported.count(vertex)) << vertex;
  }
  EXPECT_GT(reported.size(), session.chart().size() / 2) << "the brush knows that there is no end";
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(Snapshot(session) == untouched);
}

TEST(Session, ReportsAllThatChangesAtEveryEvent) {
  Session session = test::plane_session();
  session.begin_stroke(every_input());
  Snapshot before(session);
  for (const Sample& sample : test::wave()) {
    const auto changed = session.add_sample(sample.position, sample.time, sample.pen).changed;
    const std::set<Index> reported(changed.begin(), changed.end());
    EXPECT_EQ(reported.size(), changed.size());
    EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));
    const Snapshot now(session);
    EXPECT_EQ(now.positions, before.positions) << "the surface waits for the stroke's end";
    for (Index vertex = 0; vertex < session.surface().vertex_count(); ++vertex) {
      const bool same = now.shown_positions[vertex] == before.shown_positions[vertex] &&
                        now.shown_normals[vertex] == before.shown_normals[vertex];
      ASSERT_TRUE(same || reported.count(vertex)) << vertex;
    }
    before = now;
  }
  EXPECT_FALSE(session.end_stroke().empty()) << "the brush looks at the end of the stroke";
}

TEST(Session, TouchesOnlyWhatTheLastSampleReaches) {
  Session session = test::plane_session();
  session.begin_stroke(settings("org.burin.groove", 0.05));
  std::vector<std::size_t> changed;
  for (const Sample& sample : test::wave(80))
    changed.push_back(session.add_sample(sample.position, sample.time, sample.pen).changed.size());
  EXPECT_GT(session.chart().size(), 5 * *std::max_element(changed.begin() + 20, changed.end()) / 2);
}

TEST(Session, IsTheSameWhenSamplesAreShownLater) {
  for (const std::size_t show_every : {2u, 7u, 1000u}) {
    Session shown = test::plane_session(), held = test::plane_session();
    const Surface base = held.surface();
    draw(shown, every_input(), test::wave());
    held.begin_stroke(every_input());
    std::size_t i = 0, unseen = 0;
    for (const Sample& sample : test::wave()) {
      const bool now = ++i % show_every == 0;
      const StrokeEvent event =
          held.add_sample(sample.position, sample.time, sample.pen, now ? Show::now : Show::later);
      EXPECT_EQ(event.outcome, StrokeEvent::Outcome::drawn);
      EXPECT_TRUE(now || event.changed.empty());
      unseen += !now;
    }
    const auto changed = held.end_stroke();
    EXPECT_GT(changed.size(), 0u) << "what was not shown yet";
    EXPECT_GT(unseen, 10u);
    EXPECT_EQ(held.result_hash(), shown.result_hash()) << show_every;
    EXPECT_EQ(held.surface().normals, shown.surface().normals);
    expect_normals_of_positions(held);
  }
}

TEST(Session, TellsWhatTheLastCallCost) {
  Session session = test::plane_session();
  session.begin_stroke(settings("org.burin.groove", 0.05));
  add(session, test::wave(80));
  const EventCost drawn = session.cost();
  EXPECT_GT(drawn.moved, 0u);
  EXPECT_LT(drawn.moved, session.chart().size());
  for (const Stage stage : {Stage::pick, Stage::curve, Stage::chart, Stage::evaluate, Stage::move})
    EXPECT_GT(drawn.seconds[static_cast<std::size_t>(stage)], 0);
  EXPECT_EQ(drawn.seconds[static_cast<std::size_t>(Stage::record)], 0);
  session.end_stroke();
  EXPECT_GT(session.cost().seconds[static_cast<std::size_t>(Stage::record)], 0);
  EXPECT_EQ(session.cost().seconds[static_cast<std::size_t>(Stage::pick)], 0);
}

TEST(Session, GivesTheSameBitsOnOneThreadAndTwo) {
  std::set<std::uint64_t> hashes;
  for (const std::size_t threads : {1u, 2u, 2u}) {
    const ThreadLimit limit(threads);
    Session session = test::sphere_session();
    draw(session, every_input(), test::wave_on_sphere());
    draw(session, settings("org.burin.groove", 0.3), test::wave_on_sphere(9));
    hashes.insert(session.result_hash());
  }
  EXPECT_EQ(hashes.size(), 1u);
}

TEST(Session, HashesPositionsInTheOrderOfTheMesh) {
  const TriangleMesh mesh = test::plane(1, 0.1, 4);
  Session session(make_surface(mesh), test::brushes());
  const std::uint64_t untouched = session.result_hash();
  EXPECT_EQ(untouched, Session(make_surface(mesh), test::brushes()).result_hash());
  session.begin_stroke(settings("org.burin.groove", 0.3));
  add(session, test::wave());
  EXPECT_NE(session.result_hash(), untouched) << "what is shown counts";
  session.cancel_stroke();
  EXPECT_EQ(session.result_hash(), untouched);
}

TEST(Session, PicksTheSurfaceAsOfTheLastFinishedStroke) {
  Session session = test::plane_session();
  const Ray down{Vec3f(0, 0, 1), Vec3f(0, 0, -1)};
  StrokeSettings ridge = settings("org.burin.groove", 0.3);
  ridge.params = {{"depth", -1.0}, {"taper", 0.0}, {"profile", std::string("flat")}};
  std::vector<Sample> line;
  for (int i = 0; i < 20; ++i) line.push_back({0.01 * i, Vec3d(-0.5 + 0.05 * i, 0, 0), {}});
  session.begin_stroke(ridge);
  add(session, line);
  EXPECT_NEAR(session.picker().pick(down)->position.z(), 0, 1e-6);
  session.end_stroke();
  EXPECT_NEAR(session.picker().pick(down)->position.z(), 0.3, 1e-4);
  session.undo();
  EXPECT_NEAR(session.picker().pick(down)->position.z(), 0, 1e-6);
}

TEST(Session, CancelsWithoutATrace) {
  Session session = test::sphere_session();
  const Snapshot before(session);
  session.begin_stroke(every_input());
  add(session, test::wave_on_sphere());
  session.cancel_stroke();
  EXPECT_TRUE(Snapshot(session) == before);
  EXPECT_FALSE(session.undo());
  session.cancel_stroke();
}

TEST(Session, LeavesNoTraceOfAStrokeWithoutSamples) {
  Session session = test::plane_session();
  session.begin_stroke(settings("org.burin.groove"));
  EXPECT_TRUE(session.end_stroke().empty());
  EXPECT_FALSE(session.undo());
}

TEST(Session, SkipsSamplesOffTheSurface) {
  Session session = test::plane_session();
  session.begin_stroke(settings("org.burin.groove"));
  using Outcome = StrokeEvent::Outcome;
  EXPECT_EQ(session.add_sample(Vec3d(0, 0, 0.2), 0, {}).outcome, Outcome::off_surface);
  EXPECT_EQ(session.add_sample(Ray{Vec3f(5, 0, 1), Vec3f(0, 0, -1)}, 0, {}).outcome, Outcome::off_surface);
  EXPECT_EQ(session.add_sample(Vec3d(0, 0, 0.1), 0, {}).outcome, Outcome::drawn);
  EXPECT_EQ(session.add_sample(Ray{Vec3f(0.1f, 0, 1), Vec3f(0, 0, -1)}, 0.1, {}).outcome, Outcome::drawn);
  session.end_stroke();
  EXPECT_NEAR(session.curve().length(), 0.1, 1e-6);
}

TEST(Session, StrengthZeroLeavesEveryBit) {
  Session session = test::sphere_session();
  const Snapshot before(session);
  StrokeSettings faint = every_input();
  faint.strength = 0;
  session.begin_stroke(faint);
  for (const Sample& sample : test::wave_on_sphere())
    EXPECT_TRUE(session.add_sample(sample.position, sample.time, sample.pen).changed.empty());
  EXPECT_TRUE(session.end_stroke().empty());
  EXPECT_TRUE(Snapshot(session) == before);
  EXPECT_TRUE(session.undo()) << "it was a stroke all the same";
}

TEST(Session, DisplacesOnlyInsideTheChart) {
  Session session = test::sphere_session();
  const Surface base = session.surface();
  draw(session, every_input(), test::wave_on_sphere());
  const std::vector<Index>& chart = session.chart().vertex;
  std::size_t moved = 0;
  for (Index vertex = 0; vertex < base.vertex_count(); ++vertex) {
    if (session.positions()[vertex] == base.positions[vertex]) continue;
    ++moved;
    ASSERT_TRUE(std::binary_search(chart.begin(), chart.end(), vertex));
  }
  EXPECT_GT(moved, chart.size() / 2);
}

/// Draws with a brush that fails after a stroke that does not; all must be as after the good one.
std::string failure_of(const StrokeSettings& bad) {
  Session session = test::sphere_session();
  draw(session, settings("org.burin.groove"), test::wave_on_sphere());
  const Snapshot before(session);
  const std::string line = error_of([&] { draw(session, bad, test::wave_on_sphere()); });
  EXPECT_TRUE(Snapshot(session) == before) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(error_of([&] { session.end_stroke(); }), "no stroke is open");
  draw(session, settings("org.burin.groove"), test::wave_on_sphere());
  return line;
}

TEST(Session, SurvivesBrushesThatMisbehave) {
  const std::string nan = failure_of(settings("org.burin.test.nan"));
  EXPECT_EQ(nan.find("org.burin.test.nan: returned a displacement that is not finite at t = "), 0u) << nan;
  const std::string absurd = failure_of(settings("org.burin.test.absurd"));
  EXPECT_EQ(
      absurd.find("org.burin.test.absurd: returned a displacement of 150, more than 1000 radii at t = "), 0u)
      << absurd;
  EXPECT_NE(absurd.find(", d = "), std::string::npos) << absurd;
  StrokeSettings farthest = settings("org.burin.test.absurd");
  farthest.params = {{"radii", 3e38}};
  EXPECT_EQ(failure_of(farthest).find("org.burin.test.absurd: returned a displacement of 4.5e+37, more than"),
            0u);
  const std::string error = failure_of(settings("org.burin.test.error"));
  EXPECT_EQ(error.find("org.burin.test.error: the error brush never works at t = "), 0u) << error;
  const std::string thrown = failure_of(settings("org.burin.test.throwing"));
  EXPECT_EQ(thrown.find("org.burin.test.throwing: thrown by the brush at t = "), 0u) << thrown;

  StrokeSettings throws_at_begin = settings("org.burin.test.throwing");
  throws_at_begin.params = {{"where", std::string("begin")}, {"what", std::string("not_found")}};
  EXPECT_EQ(failure_of(throws_at_begin), "org.burin.test.throwing: gone");
  EXPECT_NE(failure_of(settings("org.burin.test.greedy")).find("does not offer: number 40"),
            std::string::npos);
}

TEST(Session, SaysWhatIsWrongWithSettings) {
  StrokeSettings deep = settings("org.burin.groove"), unknown = deep, no_radius = deep, faint = deep;
  deep.params = {{"depth", 70.0}};
  unknown.params = {{"colour", 1.0}};
  no_radius.radius = 0;
  faint.strength = std::numeric_limits<double>::infinity();
  EXPECT_EQ(failure_of(deep), "parameter 'depth' of org.burin.groove: 70 is above the maximum 10");
  EXPECT_EQ(failure_of(unknown),
            "org.burin.groove has no parameter 'colour'; there are: depth, width, taper, profile");
  EXPECT_EQ(failure_of(no_radius), "a stroke's radius must be above 0, not 0");
  EXPECT_EQ(failure_of(faint), "a stroke's strength is not finite");
  EXPECT_EQ(failure_of(settings("org.burin.scales")),
            "parameter 'stamp' of org.burin.scales: a file must be given");
  StrokeSettings no_stamp = settings("org.burin.scales");
  no_stamp.params = {{"stamp", std::string("/no/such/stamp.exr")}};
  EXPECT_EQ(failure_of(no_stamp).find("org.burin.scales: /no/such/stamp.exr: "), 0u);
}

TEST(Session, DropsTheStrokeOnCallsOutOfOrder) {
  Session session = test::plane_session();
  const Snapshot before(session);
  EXPECT_EQ(error_of([&] { session.add_sample(Vec3d(0, 0, 0), 0, {}); }), "no stroke is open");
  const auto mistakes = {
      +[](Session& s) { s.begin_stroke(settings("org.burin.groove")); },
      +[](Session& s) { s.undo(); },
      +[](Session& s) { s.add_sample(Vec3d(0, 0, 0), -5, {}); },
      +[](Session& s) { s.add_sample(Vec3d(0, 0, 0), std::numeric_limits<double>::quiet_NaN(), {}); },
  };
  for (const auto mistake : mistakes) {
    session.begin_stroke(every_input());
    add(session, test::wave());
    EXPECT_THROW(mistake(session), ContractError);
    EXPECT_TRUE(Snapshot(session) == before);
    EXPECT_EQ(error_of([&] { session.end_stroke(); }), "no stroke is open");
  }
}

/// Half of the wave, as a piece.
std::vector<Sample> half_wave(bool second) {
  const std::vector<Sample> all = test::wave();
  const auto middle = all.begin() + 20;
  return second ? std::vector<Sample>(middle, all.end()) : std::vector<Sample>(all.begin(), middle);
}

/// Marks the vertices at which the last stroke has nodes.
std::vector<bool> charted(const Session& session) {
  std::vector<bool> charted(session.surface().vertex_count());
  for (const Index vertex : session.chart().vertex) charted[vertex] = true;
  return charted;
}

TEST(Session, DrawsPiecesOfOneStroke) {
  for (const char* brush : {"org.burin.groove", "org.burin.smooth", "org.burin.test.every-input"}) {
    Session session = test::plane_session(), first = test::plane_session(), second = test::plane_session();
    const Snapshot before(session);
    draw(first, settings(brush), half_wave(false));
    draw(second, settings(brush), half_wave(true));
    session.begin_stroke(settings(brush));
    add(session, half_wave(false));
    session.end_piece();
    EXPECT_EQ(session.result_hash(), first.result_hash());
    EXPECT_EQ(session.curve().length(), first.curve().length());
    EXPECT_TRUE(session.end_piece().empty()) << "twice is once";
    add(session, half_wave(true));
    session.end_stroke();
    EXPECT_EQ(session.curve().length(), second.curve().length());
    const std::vector<bool> of_first = charted(first), of_second = charted(second);
    for (Index v = 0; v < session.surface().vertex_count(); ++v) {
      const Vec3f &a = first.positions()[v], &b = second.positions()[v], &both = session.positions()[v];
      if (!of_first[v] || !of_second[v]) {
        ASSERT_EQ(both, of_second[v] ? b : a) << brush;
      } else if (std::string_view(brush) == "org.burin.groove") {
        ASSERT_NEAR(both.z(), std::min(a.z(), b.z()), 1e-7f) << "as the deeper of both";
      }
    }
    EXPECT_TRUE(session.undo());
    EXPECT_TRUE(Snapshot(session) == before);
    EXPECT_FALSE(session.undo());
  }
}

TEST(Session, DropsAllPiecesOfACancelledStroke) {
  Session session = test::plane_session();
  const Snapshot before(session);
  session.begin_stroke(settings("org.burin.groove"));
  add(session, half_wave(false));
  session.end_piece();
  add(session, half_wave(true));
  session.cancel_stroke();
  EXPECT_TRUE(Snapshot(session) == before);
  EXPECT_FALSE(session.undo());
  EXPECT_EQ(error_of([&] { session.end_piece(); }), "no stroke is open");
}

TEST(Session, EndsAStrokeBetweenItsPieces) {
  Session session = test::plane_session(), whole = test::plane_session();
  draw(whole, settings("org.burin.groove"), half_wave(false));
  session.begin_stroke(settings("org.burin.groove"));
  session.end_piece();
  add(session, half_wave(false));
  session.end_piece();
  EXPECT_TRUE(session.end_stroke().empty());
  EXPECT_EQ(session.result_hash(), whole.result_hash());
  EXPECT_TRUE(session.undo());
}

TEST(Session, SparesSamplesThatDoNotLeadOn) {
  Session session = test::plane_session();
  session.begin_stroke(settings("org.burin.groove"));
  session.add_sample(Vec3d(0, 0, 0), 0, {});
  EXPECT_GT(session.cost().settled, 0u);
  for (int i = 1; i < 1000; ++i) {
    const StrokeEvent event = session.add_sample(Vec3d(1e-7 * (i % 7), 1e-7 * (i % 3), 0), i, {});
    EXPECT_EQ(event.outcome, StrokeEvent::Outcome::drawn);
    EXPECT_TRUE(event.changed.empty());
    EXPECT_EQ(session.cost().settled, 0u);
  }
  session.end_stroke();
  EXPECT_EQ(session.curve().points.size(), 1u);
}

TEST(Session, RefusesAPointSet) {
  const PointSet points =
      test::points_of(test::plane(1, 0.1, 4), [](const Vec3f&) { return Vec3f::UnitZ(); });
  EXPECT_THROW(Session(make_point_surface(points), test::brushes()), ContractError);
}

}  // namespace
}  // namespace burin
