#include <burin/deform/blend/strongest.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <vector>

namespace burin {
namespace {

const Vec3d up = Vec3d::UnitZ();

Vec3d together(const std::vector<Vec3d>& changes, const Vec3d& normal = up) {
  return strongest(changes, normal);
}

/// Some vectors of at most this length.
std::vector<Vec3d> random_changes(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vec3d> changes(count);
  for (Vec3d& change : changes) change = Vec3d(number(random), number(random), number(random));
  return changes;
}

TEST(Strongest, IsTheGreatestOfOneDirection) {
  EXPECT_EQ(strongest(std::vector<double>{0.5, 2, 1}), 2);
  EXPECT_EQ(strongest(std::vector<double>{-0.5, -2, 0}), -2);
  EXPECT_EQ(strongest(std::vector<double>{}), 0);
  for (const Vec3d& way : {Vec3d(0, 0, 1), Vec3d(0.6, 0.8, 0), Vec3d(1, 2, -3)})
    EXPECT_LT((together({0.5 * way, way, 0 * way, 0.1 * way}) - way).norm(), 1e-12);
}

TEST(Strongest, IsTheSumOfOppositeDirections) {
  EXPECT_EQ(strongest(std::vector<double>{2, -0.5, 1, -0.25}), 1.5);
  EXPECT_LT((together({{0.6, 0.8, 0}, {-0.3, -0.4, 0}}) - Vec3d(0.3, 0.4, 0)).norm(), 1e-12);
}

TEST(Strongest, IsNoLongerThanTheLongest) {
  std::mt19937 random(3);
  for (int round = 0; round < 1000; ++round) {
    const std::vector<Vec3d> changes = random_changes(random, 1 + random() % 6);
    double longest = 0;
    for (const Vec3d& change : changes) longest = std::max(longest, change.norm());
    ASSERT_LE(together(changes).norm(), longest * (1 + 1e-12));
  }
}

TEST(Strongest, HasNoSteps) {
  std::mt19937 random(4);
  double steepest = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Vec3d> changes = random_changes(random, 1 + random() % 5);
    const Vec3d nudge = 1e-7 * random_changes(random, 1).front();
    const Vec3d before = together(changes);
    changes[random() % changes.size()] += nudge;
    steepest = std::max(steepest, (together(changes) - before).norm() / nudge.norm());
    // One that has just begun to do something.
    changes.push_back(nudge);
    ASSERT_LT((together(changes) - before).norm(), 1e-5);
  }
  EXPECT_LT(steepest, 3);
}

TEST(Strongest, FollowsTurnsAndMirrors) {
  std::mt19937 random(5);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirror = Vec3d(-1, 1, 1).asDiagonal();
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3d> changes = random_changes(random, 1 + random() % 5);
    const Vec3d expected = turn * mirror * together(changes);
    for (Vec3d& change : changes) change = turn * mirror * change;
    std::ranges::shuffle(changes, random);
    ASSERT_LT((together(changes, turn * up) - expected).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace burin
