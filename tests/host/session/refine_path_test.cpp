// Strokes that refine the surface, drawn through sessions: what they split, when they do, and that undo takes
// it back.
#include <burin/surface/topology/euler.h>

#include <algorithm>

#include "refining.h"

namespace burin::test {
namespace {

TEST(RefinePath, DrawsAGrooveOnABoxOfTwelveTriangles) {
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
    if (p.x() > 1.4F && p.x() < 1.7F && p.y() > 0.3F && p.y() < 0.6F && p.z() > 0.8F)
      deepest = std::max(deepest, 1.0 - static_cast<double>(p.z()));
  Session fine(make_surface(shuffled(plane(1, 0.01, 1), 2)), brushes());
  draw_along(fine, settings("org.burin.groove", radius), straight({-0.5, 0, 0}, {0.5, 0, 0}));
  double right = 0;
  for (const Vec3f& p : fine.positions()) right = std::max(right, -static_cast<double>(p.z()));
  EXPECT_NEAR(deepest, right, 0.02 * right);
}

TEST(RefinePath, IsUndoneAndMadeAgainWithItsStroke) {
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

TEST(RefinePath, IsDroppedWithItsStroke) {
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

TEST(RefinePath, LeavesAMeshWithEnoughEdgesAlone) {
  Session refined = plane_session(), plain = plane_session();
  const std::vector<Vec3d> path = straight({-0.5, 0, 0}, {0.5, 0.2, 0});
  draw_along(refined, refining_if_coarse(), path);
  draw_along(plain, settings("org.burin.groove", radius), path);
  EXPECT_EQ(refined.generation(), 0u);
  EXPECT_TRUE(refined.refinements().empty());
  EXPECT_EQ(refined.result_hash(), plain.result_hash());
}

/// The longest edge of a surface, object units.
double longest_edge(const Surface& surface) {
  float squared = 0;
  for (Index v = 0; v < surface.vertex_count(); ++v)
    for (const Index other : surface.neighbours[v])
      squared = std::max(squared, (surface.positions[other] - surface.positions[v]).squaredNorm());
  return std::sqrt(static_cast<double>(squared));
}

// Also where deep cuts have stretched its edges.
TEST(RefinePath, LeavesAFineMeshAloneWhateverWasDrawnOnIt) {
  Session refined = plane_session(), plain = plane_session();
  const std::vector<Vec3d> first = straight({-0.5, 0, 0}, {0.5, 0.2, 0}),
                           beside = straight({-0.5, 0.09, 0}, {0.5, 0.29, 0});
  StrokeSettings deep = settings("org.burin.groove", radius);
  deep.strength = 4;
  for (Session* session : {&refined, &plain}) draw_along(*session, deep, first);
  EXPECT_GT(longest_edge(refined.surface()), radius / Refining::coarse);
  draw_along(refined, refining_if_coarse(), beside);
  draw_along(plain, settings("org.burin.groove", radius), beside);
  EXPECT_EQ(refined.generation(), 0u);
  EXPECT_EQ(refined.result_hash(), plain.result_hash());
}

TEST(RefinePath, ChangesNoTrianglesTheSecondTime) {
  Session session = box_session();
  StrokeSettings flat = refining(0.02);
  flat.strength = 0;
  draw_along(session, flat, over_the_edge());
  const std::uint64_t generation = session.generation();
  draw_along(session, flat, over_the_edge());
  EXPECT_EQ(session.generation(), generation);
  EXPECT_EQ(session.refinements().size(), 1u);
}

// A stroke on what another one refined, told where it goes or not, has the bits that it has with the length
// of edges given.
TEST(RefinePath, DrawsOnWhatAnotherStrokeRefined) {
  StrokeSettings flat = refining(radius / Refining::fine), with = refining_if_coarse(),
                 given = refining(radius / Refining::fine);
  flat.strength = 0;
  const std::vector<Vec3d> path = over_the_edge();
  Session told = box_session(), live = box_session(), right = box_session();
  for (Session* session : {&told, &live, &right}) draw_along(*session, flat, path);
  const std::uint64_t generation = told.generation();
  draw_along(told, with, path);
  draw_along(right, given, path);
  live.begin_stroke(with);
  double time = 0;
  std::size_t all_changed = 0;
  for (const Vec3d& place : path)
    all_changed += live.add_sample(place, time += 0.01, {}).changed.size() == live.surface().vertex_count();
  live.end_stroke();
  EXPECT_EQ(all_changed, 1u);
  EXPECT_EQ(told.generation(), generation);
  EXPECT_EQ(told.result_hash(), right.result_hash());
  EXPECT_EQ(live.result_hash(), right.result_hash());
}

// What strokes stretched is as fine as it was: strokes over each other refine once, and one across refines
// what was coarse, as if nothing was there.
TEST(RefinePath, RefinesForNothingThatStrokesStretched) {
  StrokeSettings high = refining_if_coarse();
  high.brush = "org.burin.dashed-line";
  high.strength = 4;
  const std::vector<Vec3d> across = straight({1.6, 0.15, 1}, {1.5, 0.85, 1});
  Session stacked = box_session(), bare = box_session();
  for (int i = 0; i < 2; ++i) draw_along(stacked, high, over_the_edge());
  ASSERT_EQ(stacked.refinements().size(), 1u);
  EXPECT_GT(longest_edge(stacked.surface()), 4 * radius / Refining::fine);
  draw_along(stacked, high, across);
  draw_along(bare, high, across);
  ASSERT_EQ(stacked.refinements().size(), 2u);
  EXPECT_LT(stacked.refinements()[1].triangles_added, bare.refinements()[0].triangles_added);
  ASSERT_TRUE(stacked.undo());
  const Everything before(stacked);
  draw_along(stacked, high, across);
  ASSERT_TRUE(stacked.undo());
  EXPECT_EQ(Everything(stacked), before);
}

// A stroke that would be refined for itself is not where others have taken most of a million triangles.
TEST(RefinePath, AddsAMillionTrianglesToASessionUnlessAsked) {
  StrokeSettings fine = refining_if_coarse();
  fine.radius = 0.02;
  const auto zigzag = [](double z) {
    std::vector<Vec3d> path;
    for (int i = 0; i < 8; ++i) {
      const double y = 0.1 + 0.1 * i;
      const std::vector<Vec3d> leg =
          straight({i % 2 == 0 ? 0.55 : 1.45, y, z}, {i % 2 == 0 ? 1.45 : 0.55, y, z});
      path.insert(path.end(), leg.begin(), leg.end());
    }
    return path;
  };
  Session session = box_session();
  const auto draw_a_dot = [&](double z) {
    const std::vector<Vec3d> path = zigzag(z);
    session.begin_stroke(fine, path);
    session.add_sample(path[0], 0, {});
    session.end_stroke();
  };
  draw_a_dot(1);
  ASSERT_EQ(session.refinements().size(), 1u);
  EXPECT_TRUE(session.warnings().empty());
  const std::uint64_t generation = session.generation();
  draw_a_dot(0);
  EXPECT_EQ(session.generation(), generation);
  ASSERT_EQ(session.warnings().size(), 1u);
  EXPECT_NE(session.warnings()[0].find("a stroke of radius 0.02 is drawn on the triangles that are there"),
            std::string::npos);
}

// Also what only the second one needs; the third has other edges, and refines for itself.
TEST(RefinePath, RefinesOnceForStrokesToCome) {
  const StrokeSettings with = refining_if_coarse();
  StrokeSettings narrow = with;
  narrow.radius = radius / 3;
  const std::vector<std::vector<Vec3d>> paths{over_the_edge(), straight({1.6, 0.15, 1}, {1.5, 0.85, 1}),
                                              straight({0.5, 0.5, 0}, {0.9, 0.5, 0})};
  std::size_t asked = 0;
  const auto later = [&] {
    ++asked;
    return std::vector<PlannedStroke>{{with, paths[1]}, {narrow, paths[2]}};
  };
  Session told = box_session();
  const Everything before(told);
  const auto draw = [&](const StrokeSettings& settings, std::size_t i, const LaterStrokes& to_come) {
    told.begin_stroke(settings, paths[i], to_come);
    for (std::size_t k = 0; k < paths[i].size(); ++k)
      told.add_sample(paths[i][k], 0.01 * static_cast<double>(k), {}, Show::later);
    told.end_stroke();
    return told.generation();
  };
  EXPECT_EQ(draw(with, 0, later), 1u);
  EXPECT_EQ(draw(with, 1, later), 1u);
  EXPECT_EQ(asked, 1u);
  EXPECT_EQ(draw(narrow, 2, {}), 2u);
  EXPECT_EQ(told.refinements().size(), 2u);
  EXPECT_EQ(euler_characteristic(told.surface()), 2);
  ASSERT_TRUE(told.undo() && told.undo() && told.undo());
  EXPECT_EQ(Everything(told), before);
}

TEST(RefinePath, RefinesWhereImagesOfTheStrokeAre) {
  Session session = box_session();
  StrokeSettings mirrored = refining(0.02);
  mirrored.symmetry.mirror_x = true;
  mirrored.symmetry.centre = Vec3d(1, 0.5, 0.5);
  draw_along(session, mirrored, over_the_edge());
  std::size_t deep = 0;
  for (const Vec3f& p : session.positions())
    deep += p.x() > 0.01F && p.x() < 0.2F && p.z() < 0.99F && p.z() > 0.9F;
  EXPECT_GT(deep, 10u);
}

TEST(RefinePath, InterpolatesColours) {
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

TEST(RefinePath, RefusesMoreThanTenMillionTriangles) {
  Session session = box_session();
  const Everything before(session);
  EXPECT_EQ(error_of([&] { session.begin_stroke(refining(1e-5), over_the_edge()); }),
            "refining the surface to edges of 1e-05 would take about 1.4e+10 triangles, more than 10000000");
  EXPECT_EQ(Everything(session), before);
  EXPECT_EQ(session.generation(), 0u);
}

TEST(RefinePath, GoesOnAsThePenComes) {
  // Told nothing of the path, and drawn on what came out of that from the start.
  Session live = box_session();
  const StrokeSettings with = refining(0.02);
  live.begin_stroke(with);
  double time = 0;
  std::size_t replaced = 0;
  for (const Vec3d& place : over_the_edge()) {
    const std::uint64_t generation = live.generation();
    const StrokeEvent event = live.add_sample(place, time += 0.01, {});
    ASSERT_EQ(event.outcome, StrokeEvent::Outcome::drawn);
    if (live.generation() == generation) continue;
    ++replaced;
    EXPECT_EQ(event.changed.size(), live.surface().vertex_count());
  }
  EXPECT_GE(replaced, 2u);
  EXPECT_LE(replaced, 8u);
  TriangleMesh mesh;
  mesh.positions.resize(live.surface().vertex_count());
  const std::vector<Index>& source = live.surface().source_vertex;
  for (Index v = 0; v < source.size(); ++v) mesh.positions[source[v]] = live.surface().positions[v];
  for (const auto& [a, b, c] : live.surface().triangles)
    mesh.triangles.push_back({source[a], source[b], source[c]});
  live.end_stroke();
  ASSERT_EQ(live.refinements().size(), 1u);
  Session told(make_surface(mesh), brushes());
  draw_along(told, with, over_the_edge());
  EXPECT_EQ(told.generation(), 0u);
  EXPECT_EQ(told.result_hash(), live.result_hash());
  EXPECT_TRUE(live.undo());
  EXPECT_EQ(live.surface().triangles.size(), 12u);
}

}  // namespace
}  // namespace burin::test
