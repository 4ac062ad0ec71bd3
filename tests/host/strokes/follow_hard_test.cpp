// Tests strokes over base surfaces on surfaces that come near themselves and on scans with defects:
// nothing outside the stroke moves, and nothing moves farther than the brush displaces it.
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "moves.h"
#include "support/relief.h"
#include "support/shared_data.h"

namespace burin {
namespace {

constexpr double hard_radius = 0.3, hard_depth = 0.25 * hard_radius;

StrokeSettings groove(double of_radius = hard_radius) {
  StrokeSettings settings = test::settings("org.burin.groove", of_radius);
  settings.params = {{"depth", 0.25}};
  return settings;
}

test::Pens pens_above() {
  test::Pens pens;
  for (int i = 0; i < 100; ++i) {
    const float x = -0.6F + 1.2F * static_cast<float>(i) / 99;
    pens.push_back({{x, 0.15F * std::sin(3 * x), 5}, {0, 0, -1}});
  }
  return pens;
}

/// A square |x|, |y| <= 1.2 at this height with bumps of this height, in shares of the radius, that
/// faces up or down.
TriangleMesh sheet(double z, double bumps, bool up, std::uint32_t seed) {
  TriangleMesh mesh = test::plane(1.2, hard_radius / 20, seed);
  for (Vec3f& at : mesh.positions)
    at.z() = static_cast<float>(z + bumps * hard_radius *
                                        test::egg_crate(at.x() / hard_radius, at.y() / hard_radius));
  if (!up)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// Two meshes as one, not joined.
TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  return mesh;
}

/// Closes two sheets of the same grid of vertices around their rims.
TriangleMesh plate(const TriangleMesh& upper, const TriangleMesh& lower) {
  const auto offset = static_cast<Index>(upper.positions.size());
  const auto columns = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(offset))));
  TriangleMesh mesh = together(upper, lower);
  const auto wall = [&](Index a, Index b) {  // a to b with the plate on its left
    mesh.triangles.push_back({a, offset + a, b});
    mesh.triangles.push_back({b, offset + a, offset + b});
  };
  for (Index i = 0; i + 1 < columns; ++i) {
    wall(i, i + 1);
    wall((i + 1) * columns - 1, (i + 2) * columns - 1);
    wall(offset - 1 - i, offset - 2 - i);
    wall((columns - 1 - i) * columns, (columns - 2 - i) * columns);
  }
  return mesh;
}

// Exact: the lower side stays bit for bit, and the upper one gets what a sheet gets that has no other side.
TEST(FollowHard, LeavesTheOtherSideOfAPlateAlone) {
  for (const double bumps : {0., 0.05}) {
    const TriangleMesh upper = sheet(0, bumps, true, 4);
    Session alone(make_surface(upper), test::brushes());
    const std::vector<Vec3d> expected = test::added(alone, groove(), pens_above());
    const auto vertices = static_cast<std::ptrdiff_t>(expected.size());
    for (const double thickness : {0.5, 0.25, 0.12}) {
      Session session(make_surface(plate(upper, sheet(-thickness * hard_radius, bumps, false, 4))),
                      test::brushes());
      const std::vector<Vec3d> moves = test::added(session, groove(), pens_above());
      EXPECT_TRUE(std::all_of(moves.begin() + vertices, moves.end(),
                              [](const Vec3d& move) { return move.isZero(0); }));
      const test::MoveError error = test::move_error({moves.begin(), moves.begin() + vertices}, expected);
      EXPECT_GT(error.moved, 3000U);
      EXPECT_LE(100 / hard_depth * error.rms, bumps > 0 ? 1 : 0.1)
          << "bumps " << bumps << ", thickness " << thickness;
    }
  }
}

TEST(FollowHard, LeavesWhatItsPartTouchesAlone) {
  const TriangleMesh upper = sheet(0, 0, true, 4);
  Session alone(make_surface(upper), test::brushes());
  const std::vector<Vec3d> expected = test::added(alone, groove(), pens_above());
  Session session(make_surface(together(upper, sheet(-1e-4, 0, false, 4))), test::brushes());
  const std::vector<Vec3d> moves = test::added(session, groove(), pens_above());
  const auto vertices = static_cast<std::ptrdiff_t>(expected.size());
  EXPECT_TRUE(
      std::all_of(moves.begin() + vertices, moves.end(), [](const Vec3d& move) { return move.isZero(0); }));
  const test::MoveError error = test::move_error({moves.begin(), moves.begin() + vertices}, expected);
  EXPECT_LE(100 / hard_depth * error.rms, 0.1);
}

// The pen jumps over a gap of three radii between two sheets in one plane, and goes on beyond it.
TEST(FollowHard, BreaksAtAGap) {
  TriangleMesh right = sheet(0, 0, true, 5);
  for (Vec3f& at : right.positions) at.x() += static_cast<float>(2.4 + 3 * hard_radius);
  for (const double follow : {0., 1.}) {
    Session session(make_surface(together(sheet(0, 0, true, 4), right)), test::brushes());
    StrokeSettings settings = groove();
    settings.follow = follow;
    session.begin_stroke(settings);
    const auto outcome = [&](float x, double time) {
      return session.add_sample(Ray{{x, 0.1F, 5}, {0, 0, -1}}, time, {}, Show::later).outcome;
    };
    EXPECT_EQ(outcome(0.9F, 0), StrokeEvent::Outcome::drawn);
    EXPECT_EQ(outcome(1.1F, 0.1), StrokeEvent::Outcome::drawn);
    EXPECT_EQ(outcome(1.6F, 0.2), StrokeEvent::Outcome::off_surface);
    EXPECT_EQ(outcome(2.3F, 0.3), StrokeEvent::Outcome::disconnected) << "follow " << follow;
    session.end_stroke();
  }
}

// Places as a recording has them that was made before the relief: their nearest places on the bumps lie to
// the side, but on the surface at the brush's scale they are where they were.
TEST(FollowHard, DoesNotShakeWhereThePensPlacesAreBesideTheRelief) {
  const TriangleMesh bumpy = sheet(0, 0.05, true, 4);
  Session with_rays(make_surface(bumpy), test::brushes()), with_places(make_surface(bumpy), test::brushes());
  const std::vector<Vec3d> expected = test::added(with_rays, groove(), pens_above());
  const std::vector<Vec3f> before(with_places.positions().begin(), with_places.positions().end());
  with_places.begin_stroke(groove());
  double time = 0;
  for (const Ray& pen : pens_above()) {
    const Vec3d place(pen.origin.x(), pen.origin.y(), 0);
    EXPECT_EQ(with_places.add_sample(place, time, {}, Show::later).outcome, StrokeEvent::Outcome::drawn);
    time += 1. / 240;
  }
  with_places.end_stroke();
  std::vector<Vec3d> moves(before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
    moves[with_places.surface().source_vertex[v]] = (with_places.positions()[v] - before[v]).cast<double>();
  const test::MoveError error = test::move_error(moves, expected);
  EXPECT_GT(error.moved, 3000U);
  EXPECT_LE(100 / hard_depth * error.rms, 1);
  EXPECT_NEAR(with_places.curve().length(), with_rays.curve().length(), 0.005 * hard_radius);
}

/// Strokes across scans with holes, wrong orientation, edges of three triangles, loose points.
class FollowFaultyScans : public testing::TestWithParam<const char*> {};

double farthest_from(const std::vector<Vec3f>& places, const Vec3f& at) {
  float least = std::numeric_limits<float>::infinity();
  for (const Vec3f& place : places) least = std::min(least, (place - at).squaredNorm());
  return std::sqrt(static_cast<double>(least));
}

TEST_P(FollowFaultyScans, MovesNothingButTheStroke) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/") + GetParam());
  const Surface surface = make_surface(triangulate(read_mesh(file)));
  double edges = 0;
  for (const auto& [a, b, c] : surface.triangles)
    edges += static_cast<double>((surface.positions[b] - surface.positions[a]).norm());
  const double r = 12 * edges / static_cast<double>(surface.triangles.size());
  Vec3f middle = Vec3f::Zero();
  for (const Vec3f& at : surface.positions) middle += at / static_cast<float>(surface.vertex_count());
  Session session(Surface(surface), test::brushes());
  std::size_t drawn = 0;
  for (const Vec3f& axis : {Vec3f(0, 0, 1), Vec3f(1, 0, 0), Vec3f(0, -1, 0)}) {
    const std::vector<Vec3f> before(session.positions().begin(), session.positions().end());
    session.begin_stroke(groove(r));
    std::vector<Vec3f> places;
    for (int i = 0; i < 40; ++i) {
      const auto along = static_cast<float>(surface.scale * (-0.3 + 0.6 * i / 39));
      const Vec3f from =
          middle + along * axis.unitOrthogonal() + static_cast<float>(2 * surface.scale) * axis;
      const Ray ray{from, -axis};
      const auto hit = session.picker().pick(ray);
      if (session.add_sample(ray, i / 240., {}, Show::later).outcome != StrokeEvent::Outcome::drawn) continue;
      places.push_back(hit->position);
    }
    session.end_stroke();
    drawn += places.size();
    if (places.empty()) continue;
    const std::vector<CurvePoint>& curve = session.curve().points;
    for (const CurvePoint& point : curve) places.push_back(point.at.position);
    for (std::size_t v = 0; v < before.size(); ++v) {
      const Vec3f& after = session.positions()[v];
      ASSERT_TRUE(after.allFinite());
      if (after == before[v]) continue;
      EXPECT_LE((after - before[v]).norm(), 0.26 * r);
      // A vertex in a fold narrower than the brush may be a radius off the base surface.
      EXPECT_LE(farthest_from(places, before[v]), 2 * r);
    }
  }
  EXPECT_GT(drawn, 10U);
}

INSTANTIATE_TEST_SUITE_P(Shared, FollowFaultyScans,
                         testing::Values("nasty/dragon_vrip_res3.ply", "nasty/capsule.obj",
                                         "nasty/moebius.obj", "stanford-bunny.obj"),
                         [](const auto& scan) { return test::test_name_of(scan.param); });

}  // namespace
}  // namespace burin
