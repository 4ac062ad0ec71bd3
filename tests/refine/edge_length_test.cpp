#include <burin/refine/edge_length.h>
#include <gtest/gtest.h>

#include <random>

namespace burin::test {
namespace {

TEST(EdgeLength, GrowsWithTheDistanceFromTheNearestLine) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return Vec3d(place(random), place(random), place(random)); };
  std::vector<std::vector<Vec3d>> lines(3);
  for (std::size_t i = 0; i < 90; ++i) lines[i % 3].push_back(point());
  lines.push_back({point()});
  constexpr double radius = 0.1, edge = 0.01;
  const EdgeLength lengths(lines, radius, edge);
  int within = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d at = point();
    double nearest = (at - lines[3][0]).norm();
    for (const std::vector<Vec3d>& line : lines)
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Vec3d along = line[k + 1] - line[k];
        const double share = std::clamp((at - line[k]).dot(along) / along.squaredNorm(), 0., 1.);
        nearest = std::min(nearest, (at - line[k] - share * along).norm());
      }
    within += nearest < radius;
    EXPECT_NEAR(lengths.at(at), edge + EdgeLength::growth * std::max(nearest - radius, 0.), 1e-12);
  }
  EXPECT_GT(within, 50);
  EXPECT_LT(within, 1950);
}

TEST(EdgeLength, SeesALineThatCrossesTheMiddleOfALongEdge) {
  const EdgeLength lengths({{{0, -1, 0.05}, {0, 1, 0.05}}}, 0.1, 0.01);
  const Vec3d from(-40, 0, 0), to(50, 0, 0);
  EXPECT_TRUE(lengths.is_exceeded(from, lengths.at(from), to, lengths.at(to), 1, 1));
  const Vec3d up(0, 0, 3);
  EXPECT_FALSE(lengths.is_exceeded(from + up, lengths.at(from + up), to + up, lengths.at(to + up), 1, 1));
}

TEST(EdgeLength, IsTheLeastThatAnySegmentSays) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1), length(0.01, 0.1);
  const auto point = [&] { return Vec3d(place(random), place(random), place(random)); };
  std::vector<EdgeLength::Around> points(200);
  for (EdgeLength::Around& around : points) {
    around.from = around.to = point();
    around.radius = length(random);
    around.edge = length(random);
  }
  const EdgeLength lengths(points);
  double least = 1;
  for (const EdgeLength::Around& around : points) least = std::min(least, around.edge);
  EXPECT_EQ(lengths.edge(), least);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d at = point();
    double right = 10;
    for (const EdgeLength::Around& around : points)
      right = std::min(
          right, around.edge + EdgeLength::growth * std::max((at - around.from).norm() - around.radius, 0.));
    EXPECT_NEAR(lengths.at(at), right, 1e-12);
  }
}

}  // namespace
}  // namespace burin::test
