// Strokes that split triangles, told as patches: a caller's arrays that follow them are the session's
// surface.
#include <burin/host/replay.h>
#include <burin/host/stroke_pieces.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "../../refine/refined.h"
#include "c_host.h"
#include "patch_follower.h"

namespace burin::test {
namespace {

const std::vector<const char*> refining = {"brush=org.burin.groove", "radius=0.12", "refine=auto"};

/// From the top of the box over its edge.
std::vector<burin_sample> over_the_edge() {
  std::vector<Vec3d> path = straight({1.2, 0.4, 1}, {2, 0.5, 1});
  for (const Vec3d& place : straight({2, 0.5, 1}, {2, 0.6, 0.3})) path.push_back(place);
  std::vector<burin_sample> samples;
  for (std::size_t i = 0; i < path.size(); i += 4) {
    auto sample = sized<burin_sample>();
    Eigen::Map<Vec3d>(sample.position) = path[i];
    samples.push_back(sample);
  }
  return samples;
}

/// The triangles of a session of C++ by the numbers of the original mesh, and of those that came after.
std::multiset<Triangle> by_source(const Session& session) {
  std::multiset<Triangle> triangles;
  for (Triangle t : session.surface().triangles) {
    for (Index& vertex : t) vertex = session.surface().source_vertex[vertex];
    triangles.insert(t);
  }
  return triangles;
}

StrokeSettings same_refining() {
  StrokeSettings made = settings("org.burin.groove", 0.12);
  made.fields = {};
  made.refining.kind = Refining::Kind::automatic;
  return made;
}

TEST(CPatch, TellsWhatStrokesSplitAndUndoTakesBack) {
  const TriangleMesh mesh = box({2, 1, 1});
  CSession session(refinable(mesh));
  Session expected(make_surface(mesh), brushes());
  Follower arrays(session);
  const std::multiset<Triangle> whole = as_set(arrays.triangles);
  EXPECT_EQ(whole.size(), 12u);

  session.begin(refining, 0);
  StrokePieces drawn(expected, same_refining());
  std::size_t news = 0;
  for (const burin_sample& sample : over_the_edge()) {
    session.add({sample});
    drawn.add(Eigen::Map<const Vec3d>(sample.position), sample.time, {});
    news += arrays.follow() > 0;
    EXPECT_EQ(as_set(arrays.triangles), by_source(expected));
  }
  EXPECT_GE(news, 1u);
  session.end();
  drawn.end();
  arrays.follow();
  EXPECT_GE(arrays.kept, 8u);
  EXPECT_GT(arrays.triangles.size(), 1000u);
  EXPECT_EQ(session.hash(), expected.result_hash());
  const std::vector<Triangle> refined = arrays.triangles;

  session.draw({"brush=org.burin.groove", "radius=0.1"}, over_the_edge());
  EXPECT_EQ(arrays.follow(), 0u) << "drawn on what is there";
  for (int i = 0; i < 2; ++i) {
    session.check(IN_C(burin_session_undo)(session, &session.error));
    EXPECT_EQ(arrays.follow() > 0, i == 1);
  }
  EXPECT_EQ(as_set(arrays.triangles), whole);
  EXPECT_EQ(session.info().vertex_count, 8u);
  EXPECT_EQ(std::memcmp(arrays.positions.data(), mesh.positions.data(), 8 * sizeof(Vec3f)), 0);
  session.check(IN_C(burin_session_redo)(session, &session.error));
  arrays.follow();
  EXPECT_EQ(as_set(arrays.triangles), as_set(refined));
  EXPECT_EQ(session.hash(), expected.result_hash());

  // The list is that of after the next patch.
  session.check(IN_C(burin_session_undo)(session, &session.error));
  std::vector<Triangle> list(session.info().triangle_count);
  session.check(
      IN_C(burin_session_read_triangles)(session, list.front().data(), list.size(), &session.error));
  arrays.follow();
  EXPECT_EQ(list, arrays.triangles);
  session.check(IN_C(burin_session_redo)(session, &session.error));
  arrays.follow();

  // Several changes at once: to the box, and to another refinement.
  session.check(IN_C(burin_session_undo)(session, &session.error));
  std::vector<burin_sample> other = over_the_edge();
  for (burin_sample& sample : other) sample.position[1] += 0.2;
  session.draw(refining, other);
  EXPECT_GT(arrays.follow(), 1000u);
}

// A wide stroke takes out what a narrow one refined: vertices behind the first that goes get other numbers.
TEST(CPatch, TellsWhatAWiderStrokeTookOut) {
  CSession session(refinable(box({2, 1, 1})));
  Follower arrays(session);
  session.draw({"brush=org.burin.groove", "radius=0.04", "refine=auto"}, over_the_edge());
  arrays.follow();
  const std::multiset<Triangle> fine = as_set(arrays.triangles);
  session.draw({"brush=org.burin.groove", "radius=0.2", "refine=auto"}, over_the_edge());
  EXPECT_GT(arrays.follow(), 1000u);
  EXPECT_GE(arrays.kept, 8u);
  EXPECT_LT(arrays.kept, arrays.positions.size() / 3);
  EXPECT_LT(as_set(arrays.triangles).size(), fine.size());
  for (const auto turn : {IN_C(burin_session_undo), IN_C(burin_session_redo), IN_C(burin_session_undo)}) {
    session.check(turn(session, &session.error));
    EXPECT_GT(arrays.follow(), 1000u);
    EXPECT_GE(arrays.kept, 8u);
  }
  EXPECT_EQ(as_set(arrays.triangles), fine);
}

TEST(CPatch, TellsOfStrokesThatAreCancelledOrFail) {
  const TriangleMesh mesh = box({2, 1, 1});
  CSession session(refinable(mesh));
  Follower arrays(session);
  const std::multiset<Triangle> whole = as_set(arrays.triangles);
  const std::uint64_t hash = session.hash();
  session.begin(refining, 0);
  session.add(over_the_edge());
  EXPECT_GT(arrays.follow(), 1000u);
  session.check(IN_C(burin_session_cancel)(session, &session.error));
  EXPECT_GT(arrays.follow(), 1000u);
  EXPECT_EQ(as_set(arrays.triangles), whole);
  session.begin({"brush=org.burin.test.error", "radius=0.12", "refine=auto"}, 0);
  EXPECT_EQ(session.try_add(over_the_edge()), BURIN_ERROR);
  arrays.follow();
  EXPECT_EQ(as_set(arrays.triangles), whole);
  EXPECT_EQ(session.hash(), hash);
  session.draw(refining, over_the_edge());
  EXPECT_GT(arrays.follow(), 1000u) << "the session goes on";
}

TEST(CPatch, IsOfTheObjectWithATransform) {
  // Mirrored and scaled by powers of two, the object's box is the world's to the bit.
  const double matrix[16] = {-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1};
  const TriangleMesh world = box({2, 1, 1});
  TriangleMesh object = world;
  for (Vec3f& p : object.positions) p = Vec3f(-p.x() / 2, p.y(), p.z() * 2);
  for (Triangle& t : object.triangles) std::swap(t[1], t[2]);
  burin_mesh arrays = refinable(object);
  arrays.transform = matrix;
  CSession session(arrays), expected(refinable(world));
  Follower mirrored(session), plain(expected);
  for (CSession* each : {&session, &expected}) each->draw(refining, over_the_edge());
  mirrored.follow();
  plain.follow();
  EXPECT_EQ(session.hash(), expected.hash());
  std::vector<Triangle> turned = plain.triangles;
  for (Triangle& t : turned) std::swap(t[1], t[2]);
  EXPECT_EQ(as_set(mirrored.triangles), as_set(turned));
  for (std::size_t i = 0; i < plain.positions.size(); ++i) {
    const float scale = i % 3 == 0 ? -0.5f : i % 3 == 1 ? 1.f : 2.f;
    ASSERT_EQ(mirrored.positions[i], plain.positions[i] * scale) << i;
  }
  for (CSession* each : {&session, &expected}) each->check(IN_C(burin_session_undo)(*each, &each->error));
  mirrored.follow();
  EXPECT_EQ(std::memcmp(mirrored.positions.data(), object.positions.data(), 8 * sizeof(Vec3f)), 0);
}

TEST(CPatch, TellsWhichTrianglesAreHidden) {
  const TriangleMesh mesh = box({2, 1, 1});
  std::vector<std::uint8_t> hidden(12);
  burin_mesh given = refinable(mesh);
  given.hidden = hidden.data();
  CSession session(given);
  Follower arrays(session);
  hidden[3] = hidden[7] = 1;
  session.check(IN_C(burin_session_hide)(session, hidden.data(), 12, &session.error));
  EXPECT_EQ(arrays.follow(), 2u);
  EXPECT_EQ(arrays.triangles.size(), 10u);
  session.begin(refining, 0);
  EXPECT_EQ(session.try_add(over_the_edge()), BURIN_ERROR);
  EXPECT_EQ(session.error.str(), "a surface with hidden triangles cannot be given others");
  EXPECT_EQ(arrays.follow(), 0u);
  session.check(IN_C(burin_session_hide)(session, nullptr, 0, &session.error));
  EXPECT_EQ(arrays.follow(), 2u);
  session.draw(refining, over_the_edge());
  arrays.follow();
  EXPECT_EQ(IN_C(burin_session_hide)(session, hidden.data(), 12, &session.error), BURIN_ERROR);
  EXPECT_EQ(session.error.str(),
            "triangles cannot be hidden while a stroke that replaced some can be undone");
}

TEST(CPatch, IsRefusedWhereNothingRefines) {
  const TriangleMesh mesh = box({2, 1, 1});
  CSession session(mesh);
  auto patch = sized<burin_patch>();
  EXPECT_EQ(IN_C(burin_session_take_patch)(session, &patch, &session.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(session.error.str(), "the session was made of a mesh that nothing refines");
  burin_session* made = nullptr;
  burin_mesh arrays = refinable(mesh);
  arrays.order = BURIN_ORDER_SURFACE;
  EXPECT_EQ(IN_C(burin_session_create)(c_brushes(), &arrays, &made, &session.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(session.error.str(), "refines wants the caller's order");
  arrays.refines = 2;
  EXPECT_EQ(IN_C(burin_session_create)(c_brushes(), &arrays, &made, &session.error), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(session.error.str(), "refines is neither 0 nor 1");
  CSession refinable_one(refinable(mesh));
  refinable_one.draw(refining, over_the_edge());
  burin_step* step = nullptr;
  EXPECT_EQ(IN_C(burin_session_take_step)(refinable_one, &step, &refinable_one.error), BURIN_ERROR);
  EXPECT_EQ(refinable_one.error.str(),
            "the last stroke made triangles or parts, so that its step stays with the session");
  EXPECT_EQ(refinable_one.info().undo_count, 1u);
}

}  // namespace
}  // namespace burin::test
