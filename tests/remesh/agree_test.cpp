#include <burin/remesh/agree.h>
#include <burin/remesh/border_loops.h>
#include <burin/remesh/join.h>
#include <gtest/gtest.h>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

using test::same;

constexpr double tolerance = 0.1;

/// A round hole of radius 2.3 in the square, and within or beside it a round bump of the field.
PointField field(const Vec3d& bump_at, double bump, double radius = 0.8) {
  return [=](const Vec3d& p) {
    const double beside = (p - bump_at).norm() / radius;
    return std::clamp((p - Vec3d(4, 4, 0)).norm() - 2.3, -0.3, 0.3) +
           (beside < 1 ? bump * (1 - beside * beside) : 0);
  };
}

PatchMesh fine() {
  PatchMesh patch = test::flat_patch(64);
  for (Vec3d& p : patch.positions) p /= 8;
  return patch;
}

PatchMesh finer_square() {
  PatchMesh patch = test::flat_patch(40);
  for (Vec3d& p : patch.positions) p = p * 0.15 + Vec3d(1.03, 1.01, 0);
  patch.kept.assign(patch.kept.size(), no_index);
  return patch;
}

PointField negative(const PointField& f) {
  return [f](const Vec3d& p) { return -f(p); };
}

struct Sides {
  Sides(const PointField& of_outer, const PointField& of_inner)
      : outer(divide(fine(), of_outer, same)), inner(divide(finer_square(), negative(of_inner), same)) {}

  void agree_within(double shallow) { agree(outer, inner, tolerance, shallow); }
  std::size_t outer_lines() const { return border_loops(kept_part(outer)).size(); }
  std::size_t inner_lines() const { return border_loops(kept_part(inner)).size(); }

  DividedPatch outer, inner;
};

const PointField plain = field({0, 0, 0}, 0);

void expect_whole(const Sides& sides) {
  const auto joined = join(kept_part(sides.outer), kept_part(sides.inner), tolerance);
  ASSERT_TRUE(joined);
  EXPECT_EQ(test::border_sides(*joined), 256);
  EXPECT_NEAR(test::twice_area(*joined), 128, 0.05);
}

TEST(Agree, LeavesWhatAgrees) {
  Sides sides(plain, plain);
  const std::vector<char> kept = sides.outer.kept;
  sides.agree_within(0.5);
  EXPECT_EQ(sides.outer.kept, kept);
  expect_whole(sides);
}

TEST(Agree, TakesIslandsAwayAndFillsHolesThatOnlyOneHas) {
  const PointField island = field({4, 4, 0}, 0.35), hole = field({4, 7.2, 0}, -0.35);
  for (const PointField& other : {island, hole}) {
    Sides outer(other, plain), inner(plain, other);
    EXPECT_EQ(outer.outer_lines(), 2u);
    EXPECT_EQ(inner.inner_lines(), 2u);
    outer.agree_within(0.1);
    inner.agree_within(0.1);
    EXPECT_EQ(outer.outer_lines(), 1u);
    EXPECT_EQ(inner.inner_lines(), 1u);
    expect_whole(outer);
    expect_whole(inner);
  }
}

TEST(Agree, KeepsDiscsThatBothHave) {
  const PointField island = field({4, 4, 0}, 0.35);
  Sides sides(island, island);
  sides.agree_within(0.1);
  EXPECT_EQ(sides.outer_lines(), 2u);
  expect_whole(sides);
}

TEST(Agree, FillsRingsFromWithin) {
  const auto ring = [](const Vec3d& p) {
    const double r = (p - Vec3d(4, 4, 0)).norm();
    return std::clamp(r - 2.3, -0.3, 0.3) + (r > 0.6 && r < 1.4 ? 0.35 : 0);
  };
  Sides sides(ring, plain);
  EXPECT_EQ(sides.outer_lines(), 3u);
  sides.agree_within(0.4);
  EXPECT_EQ(sides.outer_lines(), 1u);
  expect_whole(sides);
}

TEST(Agree, MovesNothingThatIsDeep) {
  const PointField deep = field({4, 4, 0}, 1);
  Sides sides(deep, plain);
  sides.agree_within(0.5);
  EXPECT_EQ(sides.outer_lines(), 2u);
  EXPECT_FALSE(join(kept_part(sides.outer), kept_part(sides.inner), tolerance));
}

}  // namespace
}  // namespace burin
