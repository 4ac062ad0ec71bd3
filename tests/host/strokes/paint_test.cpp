#include "host/sessions.h"

#include <burin/host/replay.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

using test::add;
using test::draw;
using test::settings;

/// Masks half of the surface: free where x >= 0.
Paint half_free(const Session& session) {
  Paint paint;
  for (const Vec3f& place : session.surface().positions) paint.mask.push_back(place.x() < 0 ? 0.0f : 1.0f);
  return paint;
}

TEST(SessionPaint, MovesNothingThatIsProtected) {
  Session session = test::plane_session(), plain = test::plane_session();
  session.set_paint(half_free(session));
  const std::vector<Vec3f> base = session.surface().positions;
  draw(session, settings("org.burin.groove"), test::wave());
  draw(plain, settings("org.burin.groove"), test::wave());
  std::size_t free = 0, held = 0;
  for (Index vertex = 0; vertex < base.size(); ++vertex) {
    if (base[vertex].x() < 0) {
      ASSERT_EQ(session.positions()[vertex], base[vertex]);
      held += plain.positions()[vertex] != base[vertex];
    } else {
      ASSERT_EQ(session.positions()[vertex], plain.positions()[vertex]);
      free += plain.positions()[vertex] != base[vertex];
    }
  }
  EXPECT_GT(held, 100u);
  EXPECT_GT(free, 100u);
}

TEST(SessionPaint, TakesHalfTheWayWhereHalfIsProtected) {
  Session session = test::plane_session(), plain = test::plane_session();
  Paint paint;
  paint.mask.assign(session.surface().vertex_count(), 0.5f);
  session.set_paint(paint);
  draw(session, settings("org.burin.groove"), test::wave());
  draw(plain, settings("org.burin.groove"), test::wave());
  for (Index vertex = 0; vertex < plain.surface().vertex_count(); ++vertex)
    ASSERT_FLOAT_EQ(session.positions()[vertex].z(), 0.5f * plain.positions()[vertex].z());
}

/// This brush paints red by (1 - (d / r)^2) with half of that as coverage, and multiplies masks by the same.
StrokeSettings painting(double strength = 1) {
  StrokeSettings every = settings("org.burin.test.every-input");
  every.strength = strength;
  return every;
}

TEST(SessionPaint, PaintsColoursAndMasksByStrength) {
  Session session = test::plane_session();
  draw(session, painting(0.5), test::wave());
  const Chart& chart = session.chart();
  const double radius = 0.15;
  std::size_t checked = 0;
  for (std::size_t node = 0; node < chart.size(); ++node) {
    const double share = chart.d[node] / radius, rim = 1 - share * share;
    const Vec4f colour = session.paint().colour[chart.vertex[node]];
    ASSERT_NEAR(colour.w(), 0.5 * 0.5 * rim, 1e-5);
    ASSERT_NEAR(session.paint().mask[chart.vertex[node]], 1 - 0.5 * (1 - rim), 1e-5);
    if (colour.w() > 0.01f) {
      ASSERT_NEAR(colour.x(), rim, 1e-4);
    }
    ++checked;
  }
  EXPECT_GT(checked, 300u);
}

TEST(SessionPaint, LeavesEverythingAtStrengthZero) {
  Session session = test::plane_session();
  const test::Snapshot before(session);
  Paint paint;
  paint.colour.assign(session.surface().vertex_count(), Vec4f(0.1f, 0.2f, 0.7f, 0.3f));
  session.set_paint(paint);
  draw(session, painting(0), test::wave());
  EXPECT_TRUE(test::Snapshot(session) == before);
  EXPECT_EQ(session.paint().colour, paint.colour);
  EXPECT_TRUE(session.paint().mask.empty());
}

/// Whether a session has colours, and masks.
std::pair<bool, bool> painted(const Session& session) {
  return {!session.paint().colour.empty(), !session.paint().mask.empty()};
}

TEST(SessionPaint, IsGoneWithTheStrokesThatMadeIt) {
  const std::pair none{false, false}, both{true, true};
  Session session = test::plane_session();
  session.begin_stroke(painting());
  EXPECT_EQ(painted(session), both);
  add(session, test::wave());
  session.cancel_stroke();
  EXPECT_EQ(painted(session), none);
  draw(session, painting(), test::wave());
  // It replaces the surface with all its paint.
  StrokeSettings refining = painting();
  refining.refining = {.kind = Refining::Kind::edge, .edge = 0.02};
  draw(session, refining, test::wave(25));
  EXPECT_EQ(session.refinements().size(), 1u);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(painted(session), both);
    session.undo();
    EXPECT_EQ(painted(session), both);
    session.undo();
    EXPECT_EQ(painted(session), none);
    session.redo();
    session.redo();
  }
  Session assigned = test::plane_session();
  assigned.set_paint({std::vector<Vec4f>(assigned.surface().vertex_count(), Paint::bare()), {}});
  draw(assigned, painting(), test::wave());
  assigned.undo();
  EXPECT_EQ(painted(assigned), std::pair(true, false)) << "what the application set stays";
}

TEST(SessionPaint, IsUndoneBitForBit) {
  Session session = test::plane_session();
  draw(session, painting(), test::wave());
  const Paint before = session.paint();
  const std::uint64_t hash = session.result_hash();
  StrokeSettings again = painting(0.7);
  again.radius = 0.1;
  draw(session, again, test::wave(25));
  const Paint after = session.paint();
  const std::uint64_t hash_after = session.result_hash();
  EXPECT_NE(hash_after, hash);
  EXPECT_NE(after.colour, before.colour);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(session.result_hash(), hash);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(session.paint().colour, after.colour);
    EXPECT_EQ(session.paint().mask, after.mask);
    EXPECT_EQ(session.result_hash(), hash_after);
  }
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.paint().colour, before.colour);
  EXPECT_EQ(session.paint().mask, before.mask);
  EXPECT_EQ(session.result_hash(), hash);
  session.begin_stroke(again);
  add(session, test::wave(25));
  session.cancel_stroke();
  EXPECT_EQ(session.paint().colour, before.colour);
  EXPECT_EQ(session.result_hash(), hash);
}

/// The copy that an application keeps of a session by uploading the vertices that are reported as changed.
struct Uploaded {
  explicit Uploaded(const Session& session)
      : positions(session.positions().begin(), session.positions().end()),
        normals(session.normals().begin(), session.normals().end()) {}

  void follow(const Session& session) {
    EXPECT_FALSE(session.changed().empty());
    EXPECT_TRUE(std::ranges::is_sorted(session.changed()));
    colours.resize(positions.size(), Paint::bare());
    for (const Index vertex : session.changed()) {
      positions[vertex] = session.positions()[vertex];
      normals[vertex] = session.normals()[vertex];
      colours[vertex] = session.paint().colour_of(vertex);
    }
  }

  void expect_all_of(const Session& session) const {
    EXPECT_TRUE(std::ranges::equal(positions, session.positions()));
    EXPECT_TRUE(std::ranges::equal(normals, session.normals()));
    for (Index vertex = 0; vertex < colours.size(); ++vertex)
      ASSERT_EQ(colours[vertex], session.paint().colour_of(vertex)) << vertex;
  }

  std::vector<Vec3f> positions, normals;
  std::vector<Vec4f> colours;
};

// Memory for paint that a dropped stroke left behind is not a part of the result.
TEST(SessionPaint, LeavesTheHashAsItWasWhenItIsCancelledOrUndone) {
  Session session = test::plane_session();
  const std::uint64_t bare = session.result_hash();
  draw(session, painting(), test::wave());
  EXPECT_NE(session.result_hash(), bare);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.result_hash(), bare);
  session.begin_stroke(painting());
  add(session, test::wave());
  session.cancel_stroke();
  EXPECT_EQ(session.result_hash(), bare);
}

TEST(SessionPaint, SaysWhatChangedWhenAStrokeIsUndoneCancelledOrFails) {
  Session session = test::plane_session();
  Uploaded uploaded(session);
  session.begin_stroke(painting());
  for (const Sample& sample : test::wave()) {
    session.add_sample(sample.position, sample.time, sample.pen);
    uploaded.follow(session);
  }
  session.end_stroke();
  session.undo();
  uploaded.follow(session);
  uploaded.expect_all_of(session);

  session.begin_stroke(painting());
  EXPECT_TRUE(session.changed().empty());
  session.add_sample(Vec3d(0, 0, 0), 0, {});
  uploaded.follow(session);
  session.cancel_stroke();
  uploaded.follow(session);
  uploaded.expect_all_of(session);

  session.begin_stroke(painting());
  session.add_sample(Vec3d(0, 0, 0), 1, {});
  uploaded.follow(session);
  EXPECT_THROW(session.add_sample(Vec3d(0.1, 0, 0), 0.5, {}), ContractError) << "time falls";
  uploaded.follow(session);
  uploaded.expect_all_of(session);
}

TEST(SessionPaint, ReportsAllThatLooksOther) {
  Session session = test::plane_session();
  session.begin_stroke(painting());
  Paint seen = session.paint();
  for (const Sample& sample : test::wave()) {
    const StrokeEvent event = session.add_sample(sample.position, sample.time, sample.pen);
    ASSERT_TRUE(std::ranges::is_sorted(event.changed));
    for (const Index vertex : event.changed) {
      seen.colour[vertex] = session.paint().colour[vertex];
      seen.mask[vertex] = session.paint().mask[vertex];
    }
    ASSERT_EQ(seen.colour, session.paint().colour);
    ASSERT_EQ(seen.mask, session.paint().mask);
  }
}

TEST(SessionPaint, RefusesPaintThatDoesNotFit) {
  Session session = test::plane_session();
  const Index count = session.surface().vertex_count();
  EXPECT_THROW(session.set_paint({{}, std::vector<float>(count - 1, 1)}), ContractError);
  EXPECT_THROW(session.set_paint({{}, std::vector<float>(count, 1.5f)}), ContractError);
  EXPECT_THROW(session.set_paint({std::vector<Vec4f>(count, Vec4f(0, 0, -1, 1)), {}}), ContractError);
  session.begin_stroke(painting());
  EXPECT_THROW(session.set_paint({}), ContractError);
  EXPECT_EQ(test::error_of([&] { session.end_stroke(); }), "no stroke is open");
}

}  // namespace
}  // namespace burin
