#include <burin/along/refine_bent.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "along/bent.h"
#include "support/rods.h"

namespace burin {
namespace {

constexpr double bent_chord = 0.001;
constexpr BendTolerance tolerance{bent_chord, 1e-4, 1000000};

LaidMesh laid_pipe(std::size_t copies) {
  const SourcePart part(test::pipe(1, 0.2, 0.2), {});
  LaidMesh laid;
  for (std::size_t i = 0; i < copies; ++i) {
    const auto from = static_cast<double>(i);
    lay(part, {CopyInterval::Part::middle, from, from + 1}, {}, true, laid);
  }
  return laid;
}

/// Around the z axis, at a distance of 1.
Vec3d around(const Vec3d& laid) {
  return {(1 - laid.y()) * std::cos(laid.x()), (1 - laid.y()) * std::sin(laid.x()), laid.z()};
}

TEST(RefineBent, KeepsEveryEdgeNearTheBend) {
  LaidMesh laid = laid_pipe(1);
  const std::vector<Vec3d> places = refine_bent(laid, around, tolerance);
  ASSERT_EQ(places.size(), laid.points.size());
  EXPECT_GT(laid.triangles.size(), 50u);
  EXPECT_LT(laid.triangles.size(), 2000u);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i], around(laid.points[i]));
  for (const Triangle& t : laid.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      for (double share = 0.1; share < 1; share += 0.1) {
        const Vec3d bent = around((1 - share) * laid.points[a] + share * laid.points[b]);
        EXPECT_LT((bent - (1 - share) * places[a] - share * places[b]).norm(), 1.05 * bent_chord);
      }
    }
  }
}

TEST(RefineBent, LeavesNoTJunction) {
  LaidMesh laid = laid_pipe(1);
  const auto skew = [](const Vec3d& p) { return Vec3d(p + Vec3d(0, 0, std::exp(3 * p.x()) * (1 + p.y()))); };
  const std::vector<Vec3d> places = refine_bent(laid, skew, tolerance);
  std::map<std::pair<Index, Index>, int> sides;
  for (const Triangle& t : laid.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++sides[std::minmax(t[i], t[(i + 1) % 3])];
  for (const auto& [edge, count] : sides) {
    if (count == 2) continue;
    EXPECT_EQ(count, 1);
    // Only the ends of the pipe are open.
    EXPECT_EQ(laid.points[edge.first].x(), laid.points[edge.second].x());
    EXPECT_EQ(std::abs(laid.points[edge.first].x() - 0.5), 0.5);
  }
}

TEST(RefineBent, KeepsTextureCoordinatesAndSides) {
  LaidMesh laid = laid_pipe(1);
  refine_bent(laid, around, tolerance);
  ASSERT_EQ(laid.triangle_uv.size(), laid.triangles.size());
  for (std::size_t i = 0; i < laid.triangles.size(); ++i) {
    const TriangleUv& uv = laid.triangle_uv[i];
    Vec3d middle = Vec3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& p = laid.points[laid.triangles[i][k]];
      EXPECT_NEAR(static_cast<double>(uv[k].x()), p.x(), 1e-6);
      middle += p / 3;
    }
    const Vec3d &a = laid.points[laid.triangles[i][0]], &b = laid.points[laid.triangles[i][1]],
                &c = laid.points[laid.triangles[i][2]];
    const Vec3d outward = (b - a).cross(c - a), from_axis = middle - Vec3d(middle.x(), -0.1, 0.1);
    EXPECT_GT(outward.dot(from_axis), 0);
    const float turned =
        (uv[1] - uv[0]).x() * (uv[2] - uv[0]).y() - (uv[1] - uv[0]).y() * (uv[2] - uv[0]).x();
    EXPECT_NE(turned, 0);
  }
}

// Copies that meet are split alike, so that they could be joined.
TEST(RefineBent, SplitsCopiesAlikeWhereTheyMeet) {
  LaidMesh laid = laid_pipe(2);
  const auto bulge = [](const Vec3d& p) { return Vec3d(p.x(), p.y() * (1 + 40 * p.z() * p.z()), p.z()); };
  const std::vector<Vec3d> places = refine_bent(laid, bulge, tolerance);
  std::map<std::pair<double, double>, int> at_seam;
  for (const Vec3d& p : laid.points)
    if (p.x() == 1) ++at_seam[{p.y(), p.z()}];
  EXPECT_GT(at_seam.size(), 8u);
  for (const auto& [place, count] : at_seam) EXPECT_EQ(count, 2);
}

TEST(RefineBent, SplitsNoShortEdgesAndTakesNotTooMany) {
  const auto torn = [](const Vec3d& p) { return Vec3d(p.x() > 0.3 ? p + Vec3d(0, 0, 1) : p); };
  LaidMesh laid = laid_pipe(1);
  refine_bent(laid, torn, {bent_chord, 0.01, 1000000});
  EXPECT_LT(laid.triangles.size(), 3000u);
  LaidMesh more = laid_pipe(1);
  EXPECT_THROW(refine_bent(more, torn, {bent_chord, 1e-6, 3000}), Error);
}

TEST(RefineBent, HasTheSameBitsOnOneThread) {
  LaidMesh all = laid_pipe(3), alone = laid_pipe(3);
  const std::vector<Vec3d> places = refine_bent(all, around, tolerance);
  const ThreadLimit one(1);
  EXPECT_TRUE(refine_bent(alone, around, tolerance) == places);
  EXPECT_TRUE(all.triangles == alone.triangles);
}

}  // namespace
}  // namespace burin
