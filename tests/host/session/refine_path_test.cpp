// Strokes that refine the surface, drawn through sessions: on a box of 12 triangles they give the groove that
// finer meshes give, and undo takes the triangles back.
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/euler.h>

#include <algorithm>
#include <limits>
#include <numbers>

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

/// A plate with round corners of slivers, whose long sides are 200 times as long as the short ones.
TriangleMesh sliver_plate() {
  constexpr int steps = 60;  // of each corner
  const auto corner = [](double x, double y, double begin, std::vector<Vec3d>& outline) {
    for (int i = 0; i <= steps; ++i) {
      const double angle = (begin + static_cast<double>(i) / steps) * std::numbers::pi / 2;
      outline.emplace_back(x + 0.2 * std::cos(angle), y + 0.2 * std::sin(angle), 0);
    }
  };
  std::vector<Vec3d> outline;
  corner(1.8, 0.2, -1, outline);
  corner(1.8, 0.8, 0, outline);
  corner(0.2, 0.8, 1, outline);
  corner(0.2, 0.2, 2, outline);
  TriangleMesh mesh;
  for (const Vec3d& p : outline)
    for (const double z : {0., 1.})
      mesh.positions.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                  static_cast<float>(z));
  const auto count = static_cast<Index>(outline.size());
  for (Index i = 0; i < count; ++i) {
    const Index a = 2 * i, b = 2 * ((i + 1) % count);
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({b, b + 1, a + 1});
    if (i == 0 || i + 1 == count) continue;
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a + 1, b + 1});
  }
  return mesh;
}

/// The mesh with edges of about this length all over.
TriangleMesh remeshed(const TriangleMesh& mesh, double edge) {
  const Surface surface = make_surface(mesh);
  std::vector<Index> all(surface.triangles.size());
  for (Index t = 0; t < all.size(); ++t) all[t] = t;
  const EdgeLength lengths({{Vec3d::Zero()}}, 100, edge);
  const Surface after = patched(surface, refine_surface(surface, lengths, all, 10'000'000).patch).surface;
  TriangleMesh result{after.positions, after.triangles};
  return result;
}

struct Difference {
  double rms = 0, most = 0;  ///< object units
  std::size_t count = 0;
};

/// How far the vertices that a stroke moved are from another surface.
Difference difference(const Session& one, const Session& other, double near) {
  const Surface& from = one.surface();
  Difference found;
  const SurfaceCurve& curve = one.curve();
  for (const Vec3f& p : from.positions) {
    const bool is_near = std::ranges::any_of(curve.points, [&](const CurvePoint& point) {
      return (point.at.position - p).squaredNorm() < static_cast<float>(near * near);
    });
    if (!is_near) continue;
    const double apart = static_cast<double>(
        (other.picker().closest(p, std::numeric_limits<float>::max())->position - p).norm());
    found.rms += apart * apart;
    found.most = std::max(found.most, apart);
    ++found.count;
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(found.count));
  return found;
}

/// Draws a stroke on a mesh that it refines, and on the same with such edges everywhere.
void expect_groove_of_uniform_mesh(const TriangleMesh& mesh, const std::vector<Vec3d>& path,
                                   const char* what) {
  SCOPED_TRACE(what);
  constexpr double edge = radius / 12, depth = 0.25 * radius;
  Session local(make_surface(mesh), brushes()), uniform(make_surface(remeshed(mesh, edge)), brushes());
  draw_along(local, refining(edge), path);
  Session automatic(make_surface(mesh), brushes());
  draw_along(automatic, refining_if_coarse(), path);
  EXPECT_EQ(automatic.refinements().size(), 1u);
  draw_along(uniform, settings("org.burin.groove", radius), path);
  const Difference found = difference(local, uniform, radius);
  EXPECT_GT(found.count, 1000u);
  EXPECT_LT(found.rms, 0.02 * depth);
  EXPECT_LT(local.surface().triangles.size(), uniform.surface().triangles.size());
}

TEST(RefinePath, GivesTheGrooveOfAUniformMesh) {
  std::vector<Vec3d> over_the_corner = straight({1.5, 0.7, 1}, {2, 0.95, 1});
  for (const Vec3d& place : straight({2, 0.95, 1}, {2, 0.6, 0.6})) over_the_corner.push_back(place);
  over_the_corner.erase(over_the_corner.begin() + 41);
  std::vector<Vec3d> around;
  for (int i = 0; i <= 60; ++i) {
    const double angle = (-1 + i / 60.) * std::numbers::pi / 2;
    around.emplace_back(1.8 + 0.2 * std::cos(angle), 0.2 + 0.2 * std::sin(angle), 0.5 + 0.3 * i / 60.);
  }
  expect_groove_of_uniform_mesh(box({2, 1, 1}), over_the_edge(), "box, over an edge");
  expect_groove_of_uniform_mesh(box({2, 1, 1}), over_the_corner, "box, over a corner");
  expect_groove_of_uniform_mesh(sliver_plate(), around, "slivers");
}

TEST(RefinePath, GivesExactDistancesOverTheEdgeOfABox) {
  Session session = box_session();
  StrokeSettings exact = refining_if_coarse();
  exact.follow = 1;
  exact.strength = 0;
  draw_along(session, exact, over_the_edge());
  // Unfolded, the path is straight on each of both faces and bends at the edge x = 2.
  const auto unfolded = [](const Vec3f& p) {
    const bool on_top = p.z() == 1;
    return Vec2d(on_top ? static_cast<double>(p.x()) : 3 - static_cast<double>(p.z()),
                 static_cast<double>(p.y()));
  };
  const std::array<Vec2d, 3> line{Vec2d(1.2, 0.4), Vec2d(2, 0.5), Vec2d(2.7, 0.6)};
  const Chart& chart = session.chart();
  double sum = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec2d at = unfolded(session.surface().positions[chart.vertex[i]]);
    double nearest = 1e9;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec2d along = line[k + 1] - line[k], way = at - line[k];
      const double share = std::clamp(way.dot(along) / along.squaredNorm(), 0., 1.);
      nearest = std::min(nearest, (way - share * along).norm());
    }
    const double t = chart.t[i], d = static_cast<double>(chart.d[i]);
    const double beyond = std::max({-t, t - chart.length, 0.});
    sum += std::abs(std::sqrt(d * d + beyond * beyond) - nearest);
  }
  ASSERT_GT(chart.size(), 5000u);
  EXPECT_LT(sum / static_cast<double>(chart.size()), 0.003 * radius);
}

TEST(RefinePath, GivesWhatAFineMeshGivesWithATenthOfItsTriangles) {
  std::vector<Vec3d> path;
  for (int i = 0; i <= 40; ++i)
    path.push_back(Vec3d(std::cos(0.02 * i), std::sin(0.02 * i), 0.2 * std::sin(0.1 * i)).normalized());
  constexpr double wide = 0.2, depth = 0.25 * wide;
  Session fine(make_surface(sphere(7, 0.1, 1)), brushes()),
      coarse(make_surface(sphere(3, 0.1, 2)), brushes());
  StrokeSettings with = settings("org.burin.groove", wide);
  draw_along(fine, with, path);
  with.refining = {.kind = Refining::Kind::edge, .edge = wide / 18};
  draw_along(coarse, with, path);
  EXPECT_LT(difference(coarse, fine, 0.9 * wide).rms, 0.01 * depth);
  EXPECT_LT(coarse.surface().triangles.size(), fine.surface().triangles.size() / 10);
}

// Dashes, which end with steps, to a hundredth of their height, on a tenth of the triangles of a fine mesh.
TEST(RefinePath, RepresentsStepsToTheErrorAskedFor) {
  constexpr double wide = 0.3;
  const std::vector<Vec3d> path = straight({-0.3, 0, 0}, {0.3, 0.1, 0});
  Session fine(make_surface(shuffled(plane(0.75, wide / 75, 1), 2)), brushes()),
      coarse(make_surface(shuffled(plane(0.75, wide / 12, 3), 4)), brushes());
  StrokeSettings with = settings("org.burin.dashed-line", wide);
  draw_along(fine, with, path);
  double height = 0;
  for (const Vec3f& p : fine.positions()) height = std::max(height, static_cast<double>(p.z()));
  EXPECT_GT(height, 0.05 * wide);
  coarse.set_paint({std::vector<Vec4f>(coarse.surface().vertex_count(), Vec4f(0.1F, 0.2F, 0.3F, 1)), {}});
  const Everything before(coarse);
  with.refining = {.kind = Refining::Kind::error, .error = 0.02};
  draw_along(coarse, with, path);
  EXPECT_EQ(coarse.changed().size(), coarse.surface().vertex_count());
  EXPECT_LT(difference(coarse, fine, wide).rms, 0.01 * height);
  EXPECT_LT(coarse.surface().triangles.size(), fine.surface().triangles.size() / 4);
  EXPECT_EQ(euler_characteristic(coarse.surface()), 1);
  ASSERT_EQ(coarse.refinements().size(), 1u);
  EXPECT_NEAR(coarse.refinements()[0].edge, wide / Refining::finest, 1e-9);
  const Everything after(coarse);
  EXPECT_EQ(coarse.undo_count(), 1u);
  ASSERT_TRUE(coarse.undo());
  EXPECT_EQ(Everything(coarse), before);
  ASSERT_TRUE(coarse.redo());
  EXPECT_EQ(Everything(coarse), after);
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
