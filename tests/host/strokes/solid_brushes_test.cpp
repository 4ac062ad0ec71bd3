// Each stock brush that makes solids, on a plane and on a sphere.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/volume/voxel_field.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

#include "host/stock_brush_uses.h"
#include "host/strokes/moves.h"
#include "support/rods.h"

namespace burin {
namespace {

using test::BrushUse, test::line;

std::vector<Vec3d> circle(double radius) {
  std::vector<Vec3d> places;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100;
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return places;
}

StrokeSettings settings_of(const BrushUse& use, double radius = 0.2) {
  StrokeSettings settings = test::settings(use.id, radius);
  settings.params = use.params;
  return settings;
}

/// Draws one stroke, and returns the part that it made.
const StrokeSolid& draw_solid(Session& session, const StrokeSettings& settings,
                              const std::vector<Vec3d>& places, Closure closure = Closure::open) {
  session.begin_stroke(settings);
  double time = 0;
  for (const Vec3d& place : places) session.add_sample(place, time += 0.01, {});
  session.end_stroke(closure);
  if (session.parts().empty()) throw Error("the stroke made no part");
  return session.parts().back();
}

/// The pieces of a mesh that hang together.
std::size_t components(const TriangleMesh& mesh) {
  std::vector<Index> parent(mesh.positions.size());
  for (Index v = 0; v < parent.size(); ++v) parent[v] = v;
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::size_t count = 0;
  for (Index v = 0; v < parent.size(); ++v) count += root(v) == v;
  return count;
}

class SolidBrushes : public testing::TestWithParam<BrushUse> {};

INSTANTIATE_TEST_SUITE_P(All, SolidBrushes, testing::ValuesIn(test::solid_brush_uses), test::name_of_use);

TEST_P(SolidBrushes, MakeClosedMeshesOfGoodTriangles) {
  Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
  for (const bool closed : {false, true}) {
    const StrokeSolid& solid =
        closed ? draw_solid(session, settings_of(GetParam()), circle(0.5), Closure::closed)
               : draw_solid(session, settings_of(GetParam()), line({-0.6, -0.1, 0}, {0.6, 0.1, 0}));
    const TriangleMesh mesh = mesh_of(solid);
    const test::Edges edges = test::edges_of(mesh);
    const std::vector<double> angles = test::angles_of(mesh);
    std::cout << fmt::format("{} triangles, least angle {:.1f}, 1 in 100 below {:.1f}\n",
                             mesh.triangles.size(), angles[0], angles[angles.size() / 100]);
    EXPECT_GT(mesh.triangles.size(), 1000u);
    EXPECT_EQ(edges.open, 0u);
    EXPECT_EQ(edges.multi, 0u);
    EXPECT_GE(angles[angles.size() / 100], 15);
    EXPECT_GT(test::extent_of(mesh).volume, 0);
  }
}

TEST_P(SolidBrushes, LeaveTheSurfaceAlone) {
  Session session(make_surface(test::sphere(5, 0.2, 6)), test::brushes());
  const test::Snapshot untouched(session);
  std::vector<Vec3d> places;
  for (int i = 0; i <= 60; ++i) places.emplace_back(std::cos(0.03 * i), std::sin(0.03 * i), 0.2);
  draw_solid(session, settings_of(GetParam()), places);
  EXPECT_TRUE(test::Snapshot(session) == untouched);
}

// To the bit, whatever is shown in between and on how many threads.
TEST_P(SolidBrushes, GiveTheSamePartHoweverItIsDrawn) {
  std::vector<std::uint64_t> hashes;
  for (const auto& [threads, show] : {std::pair{1, Show::now}, {2, Show::later}}) {
    const ThreadLimit limit(static_cast<std::size_t>(threads));
    Session session(make_surface(test::plane(1, 0.04, 4)), test::brushes());
    session.begin_stroke(settings_of(GetParam()));
    double time = 0;
    for (const Vec3d& place : circle(0.4)) session.add_sample(place, time += 0.01, {}, show);
    session.end_stroke();
    hashes.push_back(session.result_hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Chain, HasLinksThatHangTogetherAndDoNotTouch) {
  Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
  for (const bool closed : {false, true}) {
    const StrokeSolid& solid =
        closed
            ? draw_solid(session, settings_of({"org.burin.chain", {}}), circle(0.5), Closure::closed)
            : draw_solid(session, settings_of({"org.burin.chain", {}}), line({-0.7, -0.1, 0}, {0.7, 0.1, 0}));
    const TriangleMesh mesh = mesh_of(solid);
    const std::size_t links = components(mesh);
    std::cout << links << " links\n";
    EXPECT_GE(links, 5u);
    if (closed) {
      EXPECT_EQ(links % 2, 0u);
    }
    // Each is a ring.
    EXPECT_EQ(test::edges_of(mesh).euler, 0);
  }
}

TEST(Tube, HasTheVolumeOfAPipe) {
  Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
  const BrushUse pipe{"org.burin.tube",
                      {{"width", 0.3}, {"wall", 0.4}, {"ends", std::string("flat")}, {"height", 1.5}}};
  const StrokeSolid& solid = draw_solid(session, settings_of(pipe), circle(0.5), Closure::closed);
  const double outer = 0.3 * 0.2, inner = 0.6 * outer;
  const double exact = std::numbers::pi * (outer * outer - inner * inner) * session.chart().length;
  EXPECT_NEAR(test::extent_of(mesh_of(solid)).volume, exact, 0.003 * exact);
}

// Voxels lie a third of a voxel off the end, at which a distance that jumps there would be told wrongly.
TEST(Tube, EndsFlatWhereTheStrokeEnds) {
  Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
  StrokeSettings settings =
      settings_of({"org.burin.tube", {{"width", 0.3}, {"ends", std::string("flat")}, {"height", 1.5}}});
  settings.voxel = 0.01;
  const double end = 0.6033;
  const TriangleMesh mesh = mesh_of(draw_solid(session, settings, line({-end, 0, 0}, {end, 0, 0})));
  const double radius = 0.3 * 0.2, height = 1.5 * radius;
  int on_faces = 0;
  for (const Vec3f& position : mesh.positions) {
    const Vec3d p = position.cast<double>();
    // Edges are about a voxel round.
    if (std::abs(p.x()) < 0.5 || std::hypot(p.y(), p.z() - height) > radius / 2) continue;
    ++on_faces;
    EXPECT_NEAR(std::abs(p.x()), end, 0.05 * settings.voxel) << p.transpose();
  }
  EXPECT_GT(on_faces, 20);
  const double exact = std::numbers::pi * radius * radius * 2 * end;
  EXPECT_NEAR(test::extent_of(mesh).volume, exact, 0.005 * exact);
}

std::string message(const StrokeSettings& settings) {
  Session session(make_surface(test::plane(1, 0.04, 4)), test::brushes());
  try {
    draw_solid(session, settings, line({-0.5, 0, 0}, {0.5, 0, 0}));
  } catch (const Error& error) {
    EXPECT_TRUE(session.parts().empty());
    return error.what();
  }
  return "";
}

// By Pappus: the section is symmetric.
TEST(Carve, HasTheVolumeOfItsSection) {
  constexpr double mouth = 0.3 * 0.2, depth = 0.4 * 0.2, below = 1.5 * mouth, above = depth / 2;
  const std::map<std::string, double> areas{
      {"dovetail", above * 2 * mouth + depth * (mouth + below)},
      {"slot", (above + depth / 2) * 2 * mouth + depth / 2 * 2 * below}};
  for (const auto& [profile, area] : areas) {
    Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
    StrokeSettings settings = settings_of(
        {"org.burin.carve", {{"profile", profile}, {"width", 0.3}, {"depth", 0.4}, {"undercut", 0.5}}});
    settings.voxel = depth / 20;
    const TriangleMesh mesh = mesh_of(draw_solid(session, settings, circle(0.5), Closure::closed));
    const double exact = area * session.chart().length;
    EXPECT_NEAR(test::extent_of(mesh).volume, exact, 0.01 * exact) << profile;
    EXPECT_EQ(components(mesh), 1u);
    double at_mouth = 0, widest = 0;
    for (const Vec3f& place : mesh.positions) {
      const double off = std::abs(std::hypot(place.x(), place.y()) - 0.5);
      widest = std::max(widest, off);
      if (place.z() > 0.1 * depth) at_mouth = std::max(at_mouth, off);
    }
    EXPECT_NEAR(at_mouth, mouth, 0.5 * settings.voxel) << profile;
    EXPECT_NEAR(widest, below, settings.voxel) << profile << ": an undercut";
  }
}

TEST(Zipper, HasTwoRowsOfTeethThatInterlockAndDoNotTouch) {
  Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
  for (const bool closed : {false, true}) {
    const StrokeSettings settings = settings_of({"org.burin.zipper", {}});
    const TriangleMesh mesh =
        mesh_of(closed ? draw_solid(session, settings, circle(0.5), Closure::closed)
                       : draw_solid(session, settings, line({-0.7, -0.1, 0}, {0.7, 0.1, 0})));
    EXPECT_EQ(components(mesh), 2u) << "each row hangs together";
    // Of a closed one, both rows are rings. The teeth of both reach across the middle.
    EXPECT_EQ(test::edges_of(mesh).euler, closed ? 0 : 4);
    if (!closed) continue;
    const double spacing = 0.9 * 0.6 * 0.2,
                 period = session.chart().length / std::round(session.chart().length / spacing);
    std::size_t outside = 0, inside = 0;
    for (const Vec3f& place : mesh.positions) {
      const double across = 0.5 - std::hypot(place.x(), place.y());
      if (across < -0.45 * period && across > -0.5 * period) ++outside;
      if (across > 0.45 * period && across < 0.5 * period) ++inside;
    }
    EXPECT_GT(outside, 50u);
    EXPECT_GT(inside, 50u);
  }
}

/// Of what is inside over one period of the sample stamp, cubic voxels.
double stamp_volume() {
  const auto field = read_vdb(BURIN_SAMPLES "/solids/rail.vdb", {});
  constexpr double step = 0.1;
  double volume = 0;
  for (double x = step / 2; x < field->size().x(); x += step)
    for (double y = step / 2; y < field->size().y(); y += step)
      for (double z = step / 2; z < field->size().z(); z += step)
        if (field->at({x, y, z}, {true}) < 0) volume += step * step * step;
  return volume;
}

// The stamp is symmetric across the stroke, so that its volume is that along a straight line [Pappus].
TEST(VdbTrail, RepeatsTheStampAWholeNumberOfTimesAroundAClosedStroke) {
  Session session(make_surface(test::plane(1, 0.025, 4)), test::brushes());
  const BrushUse rail{"org.burin.vdb-trail", {{"stamp", std::string(BURIN_SAMPLES "/solids/rail.vdb")}}};
  const TriangleMesh mesh = mesh_of(draw_solid(session, settings_of(rail), circle(0.5), Closure::closed));
  const double voxel = 0.2 / 30, length = session.chart().length;
  const double exact = stamp_volume() / 32 * voxel * voxel * length;
  EXPECT_NEAR(test::extent_of(mesh).volume, exact, 0.01 * exact);
  // Each ring has a hole that the rail leaves open on either side, and all hang on one closed rail: a ring on
  // the rail is not connected to it.
  const auto periods = static_cast<std::size_t>(std::round(length / (32 * voxel)));
  EXPECT_EQ(components(mesh), periods + 1);
  EXPECT_EQ(test::edges_of(mesh).euler, 0) << "tori";
}

TEST(VdbTrail, SaysWhatIsWrongWithItsFile) {
  EXPECT_EQ(message(settings_of({"org.burin.vdb-trail", {{"stamp", std::string("/no/such.vdb")}}}))
                .find("org.burin.vdb-trail: /no/such.vdb: "),
            0u);
}

TEST(SolidStrokes, AreUndoneOneByOne) {
  Session session(make_surface(test::plane(1, 0.04, 4)), test::brushes());
  const std::uint64_t bare = session.result_hash();
  const StrokeSettings settings = settings_of({"org.burin.tube", {}});
  draw_solid(session, settings, line({-0.5, 0, 0}, {0.5, 0, 0}));
  const std::uint64_t one = session.result_hash();
  draw_solid(session, settings, line({0, -0.5, 0}, {0, 0.5, 0}));
  EXPECT_EQ(session.parts().size(), 2u);
  const std::uint64_t two = session.result_hash();
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.result_hash(), one);
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.result_hash(), two);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.result_hash(), one);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.result_hash(), bare);
  EXPECT_TRUE(session.parts().empty());
}

TEST(SolidStrokes, AreOnePartOfAllPiecesAndImages) {
  Session session(make_surface(test::plane(1, 0.04, 4)), test::brushes());
  StrokeSettings settings = settings_of({"org.burin.tube", {}}, 0.1);
  settings.symmetry.mirror_y = true;
  session.begin_stroke(settings);
  double time = 0;
  for (const Vec3d& place : line({-0.7, 0.3, 0}, {-0.3, 0.3, 0})) session.add_sample(place, time += 0.01, {});
  session.end_piece();
  for (const Vec3d& place : line({0.3, 0.3, 0}, {0.7, 0.3, 0})) session.add_sample(place, time += 0.01, {});
  session.end_stroke();
  ASSERT_EQ(session.parts().size(), 1u);
  EXPECT_EQ(components(mesh_of(session.parts()[0])), 4u);
}

TEST(SolidStrokes, AreRefusedWithOneLine) {
  StrokeSettings groove = test::settings("org.burin.groove", 0.2);
  groove.solid = SolidOperation::separate;
  EXPECT_EQ(message(groove), "org.burin.groove: makes no solids");
  StrokeSettings dabs = settings_of({"org.burin.tube", {}});
  dabs.dab_spacing = 0.5;
  EXPECT_EQ(message(dabs), "org.burin.tube: makes no solids of dabs");
  StrokeSettings tiny = settings_of({"org.burin.tube", {}});
  tiny.voxel = 1e-5;
  EXPECT_NE(message(tiny).find("org.burin.tube: the solid's grid would take"), std::string::npos);
  tiny.voxel = -1;
  EXPECT_EQ(message(tiny), "a solid's voxel must be 0 or above, not -1");
}

}  // namespace
}  // namespace burin
