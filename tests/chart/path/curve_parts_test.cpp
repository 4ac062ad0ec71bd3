#include <burin/chart/path/curve_parts.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

/// Points along the x axis that are 0.1 apart, which binary numbers do not hold exactly.
SurfaceCurve straight(int points) {
  SurfaceCurve curve;
  for (int i = 0; i < points; ++i) {
    CurvePoint point;
    point.t = 0.1 * i;
    point.at.position = Vec3f(static_cast<float>(point.t), 0, 0);
    point.normal = Vec3f::UnitZ();
    point.tangent = Vec3f::UnitX();
    point.width = 1;
    curve.points.push_back(point);
  }
  return curve;
}

void expect_same(const SurfaceCurve& a, const SurfaceCurve& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].t, b.points[i].t) << i;
    EXPECT_EQ(a.points[i].at.position, b.points[i].at.position) << i;
  }
}

TEST(CurveParts, PartBeginsAndEndsBetweenPoints) {
  const SurfaceCurve part = part_of(straight(20), 0.25, 0.95);
  ASSERT_EQ(part.points.size(), 9U);
  EXPECT_EQ(part.points.front().t, 0);
  EXPECT_NEAR(part.length(), 0.7, 1e-12);
  EXPECT_NEAR(part.points.front().at.position.x(), 0.25, 1e-6);
  EXPECT_NEAR(part.points.back().at.position.x(), 0.95, 1e-6);
}

// The part of a curve that grows is the part of the grown curve bit for bit, wherever both end.
TEST(CurveParts, UpdatedPartIsThatOfAFreshStart) {
  for (const double begin : {0.07, 0.1, 0.333}) {
    SurfaceCurve curve = straight(10);
    SurfaceCurve part = part_of(curve, begin, curve.length());
    for (int points = 11; points < 60; ++points) {
      const double unchanged_t = curve.points[curve.points.size() - 3].t;
      curve = straight(points);
      const double end = points % 5 == 0 ? curve.length() - 0.13 : curve.length();
      const std::size_t kept = update_part(part, curve, begin, end, unchanged_t);
      expect_same(part, part_of(curve, begin, end));
      EXPECT_GT(kept, 0U);
      EXPECT_LT(part.points[kept - 1].t, unchanged_t - begin);
    }
  }
}

TEST(CurveParts, TellWhetherTheWidthIsUniform) {
  SurfaceCurve curve = straight(4);
  EXPECT_TRUE(has_uniform_width(curve));
  curve.points[2].width = 0.5F;
  EXPECT_FALSE(has_uniform_width(curve));
}

}  // namespace
}  // namespace burin
