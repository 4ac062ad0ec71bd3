// Strokes that refine the surface, drawn through sessions: on a box of 12 triangles they give the groove that
// finer meshes give, and undo takes the triangles back.
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/euler.h>

#include <algorithm>
#include <limits>

#include "../../refine/refined.h"
#include "../sessions.h"

namespace burin::test {
namespace {

constexpr double radius = 0.12;

StrokeSettings refining(double edge) {
  StrokeSettings made = settings("org.burin.groove", radius);
  made.refining = {.kind = Refining::Kind::edge, .edge = edge};
  return made;
}

StrokeSettings refining_if_coarse() {
  StrokeSettings made = settings("org.burin.groove", radius);
  made.refining.kind = Refining::Kind::automatic;
  return made;
}

void draw_along(Session& session, const StrokeSettings& settings, const std::vector<Vec3d>& path) {
  session.begin_stroke(settings, path);
  double time = 0;
  for (const Vec3d& place : path)
    ASSERT_EQ(session.add_sample(place, time += 0.01, {}).outcome, StrokeEvent::Outcome::drawn);
  session.end_stroke();
}

Session box_session() { return Session(make_surface(box({2, 1, 1})), brushes()); }

/// From the top of the box over its edge.
std::vector<Vec3d> over_the_edge() {
  std::vector<Vec3d> path = straight({1.2, 0.4, 1}, {2, 0.5, 1});
  for (const Vec3d& place : straight({2, 0.5, 1}, {2, 0.6, 0.3})) path.push_back(place);
  path.erase(path.begin() + 41);
  return path;
}

/// All that a session has of its surface.
struct Everything {
  explicit Everything(const Session& session)
      : snapshot(session),
        triangles(session.surface().triangles),
        source(session.surface().source_vertex),
        curvature(session.surface().gauss_curvature),
        colour(session.paint().colour),
        hash(session.result_hash()) {}
  bool operator==(const Everything&) const = default;

  Snapshot snapshot;
  std::vector<Triangle> triangles;
  std::vector<Index> source;
  std::vector<float> curvature;
  std::vector<Vec4f> colour;
  std::uint64_t hash;
};

TEST(Refining, DrawsAGrooveOnABoxOfTwelveTriangles) {
  Session session = box_session();
  const std::uint64_t generation = session.generation();
  draw_along(session, refining_if_coarse(), over_the_edge());
  ASSERT_EQ(session.refinements().size(), 1u);
  const RefineReport& report = session.refinements()[0];
  EXPECT_EQ(report.triangles_removed, 12u);
  EXPECT_EQ(report.triangles_added, session.surface().triangles.size());
  EXPECT_DOUBLE_EQ(report.edge, radius / Refining::fine);
  EXPECT_NE(session.generation(), generation);
  EXPECT_EQ(euler_characteristic(session.surface()), 2);
  double deepest = 0;
  for (const Vec3f& p : session.positions())
    if (p.x() > 1.4F && p.x() < 1.7F && p.y() > 0.3F && p.y() < 0.6F && p.z() > 0.8F) deepest = std::max(deepest, 1.0 - static_cast<double>(p.z()));
  Session fine(make_surface(shuffled(plane(1, 0.01, 1), 2)), brushes());
  draw_along(fine, settings("org.burin.groove", radius), straight({-0.5, 0, 0}, {0.5, 0, 0}));
  double right = 0;
  for (const Vec3f& p : fine.positions()) right = std::max(right, -static_cast<double>(p.z()));
  EXPECT_NEAR(deepest, right, 0.02 * right);
}

TEST(Refining, IsUndoneAndMadeAgainWithItsStroke) {
  Session session = box_session();
  session.set_paint({std::vector<Vec4f>(8, Vec4f(0.1F, 0.2F, 0.3F, 1)), {}});
  const Everything before(session);
  draw_along(session, refining(0.02), over_the_edge());
  const Everything after(session);
  EXPECT_EQ(session.undo_count(), 1u);
  draw_along(session, settings("org.burin.groove", 0.1), straight({1.4, 0.3, 1}, {1.8, 0.6, 1}));
  const Everything twice(session);
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(Everything(session), after);
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(Everything(session), before);
  EXPECT_EQ(session.changed().size(), 8u);
  EXPECT_TRUE(session.refinements().empty());
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(Everything(session), after);
  EXPECT_EQ(session.refinements().size(), 1u);
  ASSERT_TRUE(session.redo());
  EXPECT_EQ(Everything(session), twice);
  ASSERT_TRUE(session.undo() && session.undo());
  draw_along(session, refining(0.02), over_the_edge());
  EXPECT_EQ(Everything(session), after);
}

TEST(Refining, IsDroppedWithItsStroke) {
  Session session = box_session();
  const Everything before(session);
  session.begin_stroke(refining(0.02), over_the_edge());
  EXPECT_GT(session.surface().triangles.size(), 1000u);
  session.cancel_stroke();
  EXPECT_EQ(Everything(session), before);
  EXPECT_EQ(session.changed().size(), 8u);
  session.begin_stroke(refining(0.02), over_the_edge());
  session.end_stroke();
  EXPECT_EQ(Everything(session), before);
  EXPECT_EQ(session.undo_count(), 0u);
  StrokeSettings failing = refining(0.02);
  failing.brush = "org.burin.test.error";
  session.begin_stroke(failing, over_the_edge());
  EXPECT_NE(error_of([&] { session.add_sample(over_the_edge()[0], 0, {}); }), "none");
  EXPECT_EQ(Everything(session), before);
}

TEST(Refining, LeavesAMeshWithEnoughEdgesAlone) {
  Session refined = plane_session(), plain = plane_session();
  const std::vector<Vec3d> path = straight({-0.5, 0, 0}, {0.5, 0.2, 0});
  draw_along(refined, refining_if_coarse(), path);
  draw_along(plain, settings("org.burin.groove", radius), path);
  EXPECT_EQ(refined.generation(), 0u);
  EXPECT_TRUE(refined.refinements().empty());
  EXPECT_EQ(refined.result_hash(), plain.result_hash());
}

TEST(Refining, ChangesNoTrianglesTheSecondTime) {
  Session session = box_session();
  StrokeSettings flat = refining(0.02);
  flat.strength = 0;
  draw_along(session, flat, over_the_edge());
  const std::uint64_t generation = session.generation();
  draw_along(session, flat, over_the_edge());
  EXPECT_EQ(session.generation(), generation);
  EXPECT_EQ(session.refinements().size(), 1u);
}

TEST(Refining, RefinesWhereImagesOfTheStrokeAre) {
  Session session = box_session();
  StrokeSettings mirrored = refining(0.02);
  mirrored.symmetry.mirror_x = true;
  mirrored.symmetry.centre = Vec3d(1, 0.5, 0.5);
  draw_along(session, mirrored, over_the_edge());
  std::size_t deep = 0;
  for (const Vec3f& p : session.positions()) deep += p.x() > 0.01F && p.x() < 0.2F && p.z() < 0.99F && p.z() > 0.9F;
  EXPECT_GT(deep, 10u);
}

TEST(Refining, InterpolatesColours) {
  Session session = box_session();
  std::vector<Vec4f> colours;
  for (const Vec3f& p : session.surface().positions) colours.emplace_back(p.x() / 2, p.y(), p.z(), 1.F);
  session.set_paint({colours, {}});
  StrokeSettings flat = refining(0.02);
  flat.strength = 0;
  draw_along(session, flat, over_the_edge());
  for (Index v = 0; v < session.surface().vertex_count(); ++v) {
    const Vec3f& p = session.surface().positions[v];
    ASSERT_LT((session.paint().colour[v] - Vec4f(p.x() / 2, p.y(), p.z(), 1)).cwiseAbs().maxCoeff(), 1e-3F);
  }
}

TEST(Refining, RefusesMoreThanTenMillionTriangles) {
  Session session = box_session();
  const Everything before(session);
  EXPECT_EQ(error_of([&] { session.begin_stroke(refining(1e-5), over_the_edge()); }),
            "refining the surface to edges of 1e-05 would take about 1.4e+10 triangles, more than 10000000");
  EXPECT_EQ(Everything(session), before);
  EXPECT_EQ(session.generation(), 0u);
}

}  // namespace
}  // namespace burin::test
