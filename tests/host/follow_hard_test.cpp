// Strokes at the brush's own scale on surfaces that come near themselves: nothing
// beyond the stroke moves, and nothing farther than the brush says.
#include <algorithm>
#include <cmath>

#include "moves.h"
#include "support/relief.h"

namespace burin {
namespace {

constexpr double radius = 0.3, depth = 0.25 * radius;

StrokeSettings groove(double of_radius = radius) {
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

/// A square |x|, |y| <= 1.2 at this height with bumps of this height, in shares of the radius, that faces up
/// or down.
TriangleMesh sheet(double z, double bumps, bool up, std::uint32_t seed) {
  TriangleMesh mesh = test::plane(1.2, radius / 20, seed);
  for (Vec3f& at : mesh.positions)
    at.z() = static_cast<float>(z + bumps * radius * test::egg_crate(at.x() / radius, at.y() / radius));
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
      Session session(make_surface(plate(upper, sheet(-thickness * radius, bumps, false, 4))),
                      test::brushes());
      const std::vector<Vec3d> moves = test::added(session, groove(), pens_above());
      EXPECT_TRUE(std::all_of(moves.begin() + vertices, moves.end(),
                              [](const Vec3d& move) { return move.isZero(0); }));
      const test::MoveError error = test::move_error({moves.begin(), moves.begin() + vertices}, expected);
      EXPECT_GT(error.moved, 3000U);
      EXPECT_LE(100 / depth * error.rms, bumps > 0 ? 1 : 0.1)
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
  EXPECT_LE(100 / depth * error.rms, 0.1);
}

}  // namespace
}  // namespace burin
