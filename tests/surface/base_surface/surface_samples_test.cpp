#include <burin/surface/base_surface/surface_samples.h>
#include <gtest/gtest.h>

#include <vector>

namespace burin {
namespace {

TEST(SurfaceSamples, KeepTheOrderAndFillUpWithNoArea) {
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < SurfaceSamples::lanes + 3; ++i) {
    const auto x = static_cast<float>(i);
    samples.push_back({Vec3f(x, 2 * x, 3 * x), Vec3f(1, x, 0)});
  }
  const SurfaceSamples in_lanes(samples);
  ASSERT_EQ(in_lanes.blocks().size(), 2U);
  const SurfaceSamples::Block &first = in_lanes.blocks()[0], &last = in_lanes.blocks()[1];
  EXPECT_EQ(first.position.z[7], 21);
  EXPECT_EQ(first.up.y[7], 7);
  EXPECT_EQ(last.position.y[2], 20);
  EXPECT_EQ(last.up.x.sum(), 3);
  EXPECT_EQ(last.up.squared_length()[5], 0);
  EXPECT_TRUE(last.position.x.isFinite().all());
  EXPECT_EQ(first.from(Vec3f(1, 1, 1)).dot(Vec3f(0, 0, 2))[1], 4);
}

TEST(SurfaceSamples, MayBeNone) { EXPECT_TRUE(SurfaceSamples({}).blocks().empty()); }

}  // namespace
}  // namespace burin
