// Undoes and redoes strokes, bounds what that holds, and takes what others moved: what a session does with
// its surface between strokes.
#include <burin/base/error.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "host/sessions.h"

namespace burin {
namespace {

using test::draw;
using test::settings;
using test::Snapshot;

/// Draws three strokes. Returns the states before, between and after them.
std::vector<Snapshot> draw_three(Session& session) {
  std::vector<Snapshot> states = {Snapshot(session)};
  for (const double radius : {0.1, 0.3, 0.2}) {
    draw(session, settings("org.burin.groove", radius), test::wave_on_sphere());
    states.emplace_back(session);
    EXPECT_FALSE(states.back() == states[states.size() - 2]);
  }
  return states;
}

TEST(SculptedSurface, UndoesStrokesBitForBit) {
  Session session = test::sphere_session();
  const std::vector<Snapshot> states = draw_three(session);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    EXPECT_TRUE(session.undo());
    EXPECT_TRUE(Snapshot(session) == states[i]) << i;
  }
  EXPECT_FALSE(session.undo());
  draw(session, settings("org.burin.groove", 0.1), test::wave_on_sphere());
  EXPECT_TRUE(Snapshot(session) == states[1]) << "as if nothing had ever been undone";
}

TEST(SculptedSurface, MakesUndoneStrokesAgainBitForBit) {
  Session session = test::sphere_session();
  const std::vector<Snapshot> states = draw_three(session);
  EXPECT_FALSE(session.redo());
  for (int i = 0; i < 2; ++i) session.undo();
  EXPECT_EQ(session.undo_count(), 1u);
  EXPECT_EQ(session.redo_count(), 2u);
  for (const std::size_t i : {2u, 3u}) {
    EXPECT_TRUE(session.redo());
    EXPECT_FALSE(session.changed().empty());
    EXPECT_TRUE(Snapshot(session) == states[i]) << i;
  }
  EXPECT_FALSE(session.redo());
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(Snapshot(session) == states[2]);
  draw(session, settings("org.burin.groove", 0.2), test::wave_on_sphere());
  EXPECT_TRUE(Snapshot(session) == states[3]) << "as if nothing had ever been made again";
  EXPECT_FALSE(session.redo()) << "another stroke was drawn";
  session.undo();
  session.begin_stroke(settings("org.burin.groove"));
  session.cancel_stroke();
  EXPECT_TRUE(session.redo()) << "a stroke that was cancelled changed nothing";
  session.begin_stroke(settings("org.burin.groove"));
  EXPECT_THROW(session.redo(), ContractError);
}

TEST(SculptedSurface, ForgetsTheOldestStrokesBeyondTheBound) {
  Session session = test::sphere_session();
  std::vector<Snapshot> states = {Snapshot(session)};
  std::vector<std::size_t> bytes = {0};
  for (const double radius : {0.1, 0.3, 0.2}) {
    draw(session, settings("org.burin.groove", radius), test::wave_on_sphere());
    states.emplace_back(session);
    bytes.push_back(session.undo_bytes());
    EXPECT_GT(bytes.back(), bytes[bytes.size() - 2] + 1000);
  }
  session.undo();
  EXPECT_EQ(session.undo_bytes(), bytes[3]) << "what is undone is held, too";
  session.redo();
  session.limit_undo(bytes[3] - 1);
  EXPECT_EQ(session.undo_count(), 2u);
  EXPECT_EQ(session.undo_bytes(), bytes[3] - bytes[1]);
  draw(session, settings("org.burin.groove", 0.3), test::wave_on_sphere());
  EXPECT_LE(session.undo_bytes(), bytes[3] - 1);
  EXPECT_EQ(session.undo_count(), 2u);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(Snapshot(session) == states[3]);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(Snapshot(session) == states[2]);
  EXPECT_FALSE(session.undo());
  session.limit_undo(0);
  EXPECT_EQ(session.redo_count(), 2u) << "strokes that were undone are not older than the surface";
  EXPECT_TRUE(session.redo());
}

/// [vertex of the mesh] what a session has of it.
template <class Values>
auto by_source(const Session& session, const Values& values) {
  std::vector<std::ranges::range_value_t<Values>> sorted(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) sorted[session.surface().source_vertex[v]] = values[v];
  return sorted;
}

double farthest(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b) {
  float farthest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, (a[i] - b[i]).norm());
  return farthest;
}

// The other surface has another order of vertices, and therefore sums of another order.
TEST(SculptedSurface, TakesWhatOtherToolsMoved) {
  const TriangleMesh mesh = test::shuffled(test::plane(1, 0.02, 4), 5);
  TriangleMesh moved = mesh;
  for (Vec3f& place : moved.positions) place.z() += 0.2f * std::max(0.f, 0.4f - place.head<2>().norm());
  Session session(make_surface(mesh), test::brushes()), expected(make_surface(moved), test::brushes());
  std::vector<Index> vertices;
  std::vector<Vec3f> positions;
  for (Index v = 0; v < session.surface().vertex_count(); ++v) {
    const Vec3f& place = moved.positions[session.surface().source_vertex[v]];
    if (place == session.positions()[v]) continue;
    vertices.push_back(v);
    positions.push_back(place);
  }
  ASSERT_GT(vertices.size(), 1000u);
  session.move_vertices(vertices, positions);
  EXPECT_GT(session.changed().size(), vertices.size()) << "their neighbours have other normals";
  EXPECT_LT(static_cast<double>(session.changed().size()), 1.2 * static_cast<double>(vertices.size()));
  EXPECT_EQ(session.undo_count(), 0u);
  EXPECT_EQ(session.result_hash(), expected.result_hash());
  EXPECT_LT(farthest(by_source(session, session.normals()), by_source(expected, expected.normals())), 1e-5);
  const std::vector<float> curvature = by_source(session, session.surface().gauss_curvature),
                           right = by_source(expected, expected.surface().gauss_curvature);
  for (std::size_t v = 0; v < right.size(); ++v)
    ASSERT_NEAR(curvature[v], right[v], 1e-3 + 1e-3 * std::abs(right[v]));
  const Ray down{Vec3f(0.01f, 0, 1), Vec3f(0, 0, -1)};
  EXPECT_NEAR(session.picker().pick(down)->position.z(), 0.078, 0.004);
  StrokeSettings follow = settings("org.burin.groove");
  follow.follow = 1;
  draw(session, follow, test::wave());
  draw(expected, follow, test::wave());
  EXPECT_LT(farthest(by_source(session, session.positions()), by_source(expected, expected.positions())),
            1e-4);

  const Snapshot before(session);
  const Vec3f nan(0, std::numeric_limits<float>::quiet_NaN(), 0);
  EXPECT_THROW(session.move_vertices(vertices, {}), ContractError);
  EXPECT_THROW(session.move_vertices(std::vector<Index>{0}, std::vector<Vec3f>{nan}), ContractError);
  EXPECT_THROW(session.move_vertices(std::vector<Index>{99999}, std::vector<Vec3f>{Vec3f::Zero()}),
               ContractError);
  EXPECT_TRUE(Snapshot(session) == before);
}

TEST(SculptedSurface, HidesTrianglesUntilTheyAreShownAgain) {
  Session session = test::sphere_session();
  const Surface before = session.surface();
  std::vector<bool> hidden;
  for (const Triangle& t : before.triangles) hidden.push_back(before.positions[t[0]].x() > 0);
  session.hide(hidden);
  EXPECT_LT(session.surface().triangles.size(), before.triangles.size() * 6 / 10);
  EXPECT_EQ(session.changed().size(), before.vertex_count());
  const Ray from_right{Vec3f(9, 0.01F, 0.02F), Vec3f(-1, 0, 0)};
  EXPECT_LT(session.picker().pick(from_right)->position.x(), -0.9F) << "the inside of the other half";
  std::vector<Sample> shown_part = test::wave_on_sphere();
  std::erase_if(shown_part, [](const Sample& sample) { return sample.position.x() > -0.1; });
  draw(session, settings("org.burin.groove", 0.1), shown_part);
  EXPECT_TRUE(session.undo());
  session.hide(std::vector<bool>());
  EXPECT_EQ(session.surface().triangles, before.triangles);
  EXPECT_EQ(session.surface().positions, before.positions);
  EXPECT_EQ(session.surface().normals, before.normals);
  EXPECT_EQ(session.surface().gauss_curvature, before.gauss_curvature);
  EXPECT_EQ(session.surface().neighbours.items, before.neighbours.items);
}

TEST(SculptedSurface, HasEitherHiddenOrReplacedTriangles) {
  Session session = test::plane_session();
  StrokeSettings refining = settings("org.burin.groove");
  refining.refining = {.kind = Refining::Kind::edge, .edge = 0.01};
  std::vector<bool> hidden(session.surface().triangles.size());
  hidden[5] = true;
  session.hide(hidden);
  session.begin_stroke(refining);
  EXPECT_EQ(test::error_of([&] { session.add_sample(Vec3d(0, 0, 0), 0, {}); }),
            "a surface with hidden triangles cannot be given others");
  EXPECT_EQ(session.generation(), 0u);
  session.hide({});
  draw(session, refining, test::wave(4));
  EXPECT_NE(session.generation(), 0u);
  EXPECT_EQ(test::error_of([&] { session.hide(hidden); }),
            "triangles cannot be hidden while a stroke that replaced some can be undone");
  EXPECT_EQ(test::error_of([&] { session.take_step(); }),
            "the last stroke made triangles or parts, so that its step stays with the session");
  EXPECT_EQ(session.undo_count(), 1u);
  EXPECT_TRUE(session.undo());
  session.limit_undo(0);
  EXPECT_FALSE(session.take_step());
  EXPECT_EQ(test::error_of([&] { session.hide({true}); }),
            "triangles cannot be hidden while a stroke that replaced some can be undone");
}

}  // namespace
}  // namespace burin
