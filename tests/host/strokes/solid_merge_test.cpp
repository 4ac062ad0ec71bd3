// Strokes whose solids become part of the surface.
#include <burin/base/error.h>
#include <burin/level_set/solid_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "host/sessions.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

std::vector<Vec3d> arc(double from, double to) {
  std::vector<Vec3d> places;
  for (int i = 0; i <= 40; ++i) {
    const double angle = from + i / 40. * (to - from);
    places.push_back({std::cos(angle), std::sin(angle), 0});
  }
  return places;
}

StrokeSettings tube(SolidOperation operation) {
  StrokeSettings settings = test::settings("org.burin.tube", 0.2);
  settings.params = {{"height", 0.0}};
  settings.solid = operation;
  settings.voxel = 0.015;
  return settings;
}

void draw_along(Session& session, const StrokeSettings& settings, const std::vector<Vec3d>& places) {
  session.begin_stroke(settings);
  double time = 0;
  for (const Vec3d& place : places) session.add_sample(place, time += 0.01, {});
  session.end_stroke();
}

Session sphere_session(SolidMerger merger = merge_solid) {
  return Session(make_surface(test::sphere(5, 0.2, 3)), test::brushes(), std::move(merger));
}

TriangleMesh mesh_of(const Session& session) {
  return {session.surface().positions, session.surface().triangles, {}};
}

TEST(SolidMerge, IsUndoneExactly) {
  Session session = sphere_session();
  draw_along(session, test::settings("org.burin.bead", 0.2), arc(2, 3));
  const std::uint64_t before = session.result_hash();
  const std::vector<Triangle> triangles = session.surface().triangles;
  draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
  EXPECT_NE(session.result_hash(), before);
  EXPECT_EQ(session.generation(), 1u);
  EXPECT_EQ(session.changed().size(), session.surface().vertex_count());
  ASSERT_EQ(session.merges().size(), 1u);
  EXPECT_EQ(session.merges()[0].euler_after, 2);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.result_hash(), before);
  EXPECT_TRUE(session.surface().triangles == triangles);
  EXPECT_EQ(session.generation(), 2u);
  EXPECT_TRUE(session.merges().empty());
  EXPECT_TRUE(session.undo());
  EXPECT_FALSE(session.undo());
}

TEST(SolidMerge, IsMadeAgainExactly) {
  const auto drawn = [](bool again) {
    Session session = sphere_session();
    draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
    if (again) {
      const std::uint64_t united = session.result_hash();
      const std::vector<Triangle> triangles = session.surface().triangles;
      for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(session.undo());
        EXPECT_TRUE(session.merges().empty());
        EXPECT_TRUE(session.redo());
        EXPECT_EQ(session.result_hash(), united);
        EXPECT_TRUE(session.surface().triangles == triangles);
        EXPECT_EQ(session.merges().size(), 1u);
        EXPECT_EQ(session.changed().size(), session.surface().vertex_count());
      }
    }
    draw_along(session, test::settings("org.burin.bead", 0.15), arc(-0.3, 0.3));
    return session.result_hash();
  };
  EXPECT_EQ(drawn(true), drawn(false)) << "the next stroke runs on the same ground";
}

TEST(SolidMerge, GoesOnFromTheResult) {
  Session session = sphere_session();
  draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
  const double united = test::extent_of(mesh_of(session)).volume;
  // Across the tube, and along it once more.
  draw_along(session, test::settings("org.burin.bead", 0.15), arc(-0.3, 0.3));
  EXPECT_GT(test::extent_of(mesh_of(session)).volume, united);
  const std::uint64_t beaded = session.result_hash();
  const double with_bead = test::extent_of(mesh_of(session)).volume;
  draw_along(session, tube(SolidOperation::difference), arc(-0.2, 0.8));
  EXPECT_LT(test::extent_of(mesh_of(session)).volume, with_bead);
  const test::Edges edges = test::edges_of(mesh_of(session));
  EXPECT_EQ(edges.open + edges.multi, 0u);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.result_hash(), beaded);
}

TEST(SolidMerge, IsTheSameFromSampleToSampleAndAtOnce) {
  const auto hash = [](Show show) {
    Session session = sphere_session();
    session.begin_stroke(tube(SolidOperation::unite));
    double time = 0;
    for (const Vec3d& place : arc(-0.5, 0.5)) session.add_sample(place, time += 0.01, {}, show);
    session.end_stroke();
    return session.result_hash();
  };
  EXPECT_EQ(hash(Show::now), hash(Show::later));
}

// At each of the calls in turn.
TEST(SolidMerge, IsCancelledByItsProgressAndLeavesTheSurfaceAsItWas) {
  Session session = sphere_session();
  draw_along(session, test::settings("org.burin.bead", 0.2), arc(2, 3));
  const std::uint64_t before = session.result_hash();
  std::vector<std::string> stages;
  session.set_progress([&](std::string_view stage, double done) {
    EXPECT_TRUE(done >= 0 && done <= 1) << stage;
    stages.emplace_back(stage);
  });
  draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
  const std::uint64_t merged = session.result_hash();
  session.undo();
  const std::set<std::string> different(stages.begin(), stages.end());
  EXPECT_EQ(different.size(), 6u) << "making, comparing, contouring, joining, remeshing, rebuilding";
  struct Cancel {};
  for (std::size_t last = 0; last < stages.size(); ++last) {
    std::size_t calls = 0;
    session.set_progress([&](std::string_view, double) {
      if (calls++ == last) throw Cancel{};
    });
    EXPECT_THROW(draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5)), Cancel) << stages[last];
    EXPECT_EQ(session.result_hash(), before) << stages[last];
    EXPECT_TRUE(session.merges().empty());
  }
  session.set_progress({});
  draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
  EXPECT_EQ(session.result_hash(), merged);
}

TEST(SolidMerge, CarriesPaint) {
  Session session = sphere_session();
  Paint paint;
  for (const Vec3f& p : session.surface().positions)
    paint.colour.push_back({1, 0, 0, p.z() > 0 ? 1.0F : 0.0F});
  session.set_paint(paint);
  draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
  const Surface& surface = session.surface();
  ASSERT_EQ(session.paint().colour.size(), surface.vertex_count());
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    // Edges are about 0.04 long.
    if (std::abs(surface.positions[v].z()) < 0.08F) continue;
    EXPECT_NEAR(session.paint().colour[v].w(), surface.positions[v].z() > 0 ? 1 : 0, 1e-6);
  }
  session.undo();
  EXPECT_TRUE(session.paint().colour == paint.colour);
}

// Texture coordinates (x, y), which are linear in space: so are those of new triangles on the sphere.
TEST(SolidMerge, CarriesTextureCoordinates) {
  TriangleMesh mesh = test::sphere(5, 0.2, 3);
  const auto uv_of = [](const Vec3f& p) { return Vec2f(p.x(), p.y()); };
  for (const Triangle& t : mesh.triangles)
    mesh.triangle_uv.push_back(
        {uv_of(mesh.positions[t[0]]), uv_of(mesh.positions[t[1]]), uv_of(mesh.positions[t[2]])});
  Session session(make_surface(mesh), test::brushes(), merge_solid);
  const std::vector<TriangleUv> before = session.surface().triangle_uv;
  draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
  const Surface& surface = session.surface();
  ASSERT_EQ(surface.triangle_uv.size(), surface.triangles.size());
  std::size_t on_sphere = 0;
  for (Index t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f& p = surface.positions[surface.triangles[t][i]];
      if (std::abs(p.norm() - 1) > 1e-3F) continue;
      ++on_sphere;
      // A triangle's plane leaves the next one's by the bend of an edge over its length.
      EXPECT_LT((surface.triangle_uv[t][i] - uv_of(p)).norm(), 2e-3F) << p.transpose();
    }
  EXPECT_GT(on_sphere, surface.triangles.size()) << "the sample is not representative";
  session.undo();
  EXPECT_TRUE(session.surface().triangle_uv == before);
}

// A high bead refines a coarse sphere. What it stretched is not refined again for one over it and the tube,
// whose vertices are new: it refines less than on the bare sphere with the tube.
TEST(SolidMerge, LeavesWhatWasStretchedFine) {
  StrokeSettings bead = test::settings("org.burin.bead", 0.12);
  bead.strength = 2;
  bead.refining.kind = Refining::Kind::automatic;
  const auto drawn = [&](bool first) {
    Session session(make_surface(test::sphere(4, 0.2, 3)), test::brushes(), merge_solid);
    const std::uint64_t before = session.result_hash();
    if (first) draw_along(session, bead, arc(-0.4, 1));
    draw_along(session, tube(SolidOperation::unite), arc(-0.5, 0.5));
    draw_along(session, bead, arc(-0.6, 0.9));
    std::size_t added = 0;
    for (const RefineReport& report : session.refinements()) added += report.triangles_added;
    if (first) added -= session.refinements()[0].triangles_added;
    while (session.undo()) {
    }
    EXPECT_EQ(session.result_hash(), before);
    return added;
  };
  const std::size_t bare = drawn(false);
  EXPECT_GT(bare, 1000u);
  EXPECT_LT(drawn(true), bare);
}

TEST(SolidMerge, RefusesAndLeavesTheSurfaceAsItWas) {
  Session plain = sphere_session({});
  const std::uint64_t before = plain.result_hash();
  plain.begin_stroke(tube(SolidOperation::unite));
  plain.add_sample(Vec3d(1, 0, 0), 0, {});
  EXPECT_THROW(plain.end_stroke(), Error);
  EXPECT_EQ(plain.result_hash(), before);
  EXPECT_FALSE(plain.undo());
  draw_along(plain, test::settings("org.burin.bead", 0.2), arc(0, 1));
  EXPECT_NE(plain.result_hash(), before);
}

}  // namespace
}  // namespace burin
