#include <burin/base/error.h>
#include <burin/stroke/symmetry.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(Symmetry, DrawsNothingElseUnlessAsked) {
  const auto instances = symmetry_instances({});
  ASSERT_EQ(instances.size(), 1u);
  EXPECT_EQ(instances[0](Vec3d(1, 2, 3)), Vec3d(1, 2, 3));
  EXPECT_FALSE(instances[0].mirrored);
}

TEST(Symmetry, MirrorsAlongEachAxisAndTheirCombinations) {
  const auto instances = symmetry_instances({.mirror_x = true, .mirror_z = true, .centre = Vec3d(1, 0, 0)});
  ASSERT_EQ(instances.size(), 4u);
  const Vec3d place(3, 4, 5);
  const Vec3d expected[] = {{3, 4, 5}, {-1, 4, 5}, {3, 4, -5}, {-1, 4, -5}};
  const bool mirrored[] = {false, true, true, false};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(instances[i](place), expected[i]) << i;
    EXPECT_EQ(instances[i].mirrored, mirrored[i]) << i;
    EXPECT_EQ(instances[i].index, i);
  }
}

TEST(Symmetry, TurnsAroundItsAxis) {
  const auto instances = symmetry_instances({.mirror_y = true, .radial = 4, .axis = 2});
  ASSERT_EQ(instances.size(), 8u);
  EXPECT_LT((instances[2](Vec3d(1, 0.5, 2)) - Vec3d(-0.5, 1, 2)).norm(), 1e-15);
  EXPECT_FALSE(instances[2].mirrored);
  EXPECT_LT((instances[3](Vec3d(1, 0.5, 2)) - Vec3d(0.5, 1, 2)).norm(), 1e-15) << "mirrored first";
  EXPECT_TRUE(instances[3].mirrored);
}

TEST(Symmetry, HasNoImageTwice) {
  // Mirroring in x and z is half a turn around y.
  const auto instances = symmetry_instances({.mirror_x = true, .mirror_z = true, .radial = 6});
  EXPECT_EQ(instances.size(), 12u);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    EXPECT_EQ(instances[i].index, i);
    for (std::size_t other = 0; other < i; ++other)
      EXPECT_GT((instances[i](Vec3d(1, 2, 3)) - instances[other](Vec3d(1, 2, 3))).norm(), 0.1);
  }
  EXPECT_EQ(symmetry_instances({.mirror_x = true, .mirror_z = true, .radial = 3}).size(), 12u);
}

TEST(Symmetry, RefusesWhatIsNone) {
  EXPECT_THROW(symmetry_instances({.radial = 0}), ContractError);
  EXPECT_THROW(symmetry_instances({.axis = 3}), ContractError);
  EXPECT_THROW(symmetry_instances({.mirror_x = true, .radial = 513}), ContractError);
}

}  // namespace
}  // namespace burin
