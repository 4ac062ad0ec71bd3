#include <burin/abi/ext/vdb_stamps.h>
#include <burin/base/parallel.h>
#include <burin/host/plugin/services.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace burin {
namespace {

const std::string rail = BURIN_SAMPLES "/solids/rail.vdb";

const burin_vdb_stamps* service_of(const HostServices& services) {
  return static_cast<const burin_vdb_stamps*>(
      services.abi()->get_extension(services.abi(), BURIN_EXT_VDB_STAMPS));
}

/// The service as a plugin sees it.
class VdbStampService : public testing::Test {
 protected:
  burin_status open(const char* path, std::uint32_t periodic = BURIN_VDB_PERIODIC_X,
                    const char* grid = nullptr) {
    const burin_vdb_options options{sizeof options, periodic, grid, 0};
    burin_text text{sizeof(burin_text), static_cast<std::uint32_t>(text_.size()), text_.data()};
    info_.struct_size = sizeof info_;
    return vdb_->open(services_.abi(), path, &options, &stamp_, &info_, &text);
  }
  burin_status sample(std::uint32_t count, const float* x, float* values, float voxel = 1) {
    const float middle = static_cast<float>(info_.size[1]) / 2 * voxel, up = 0.4F * middle;
    return vdb_->sample(services_.abi(), stamp_, count, {&voxel, 0, 0}, {x, 1, 0}, {&middle, 0, 0},
                        {&up, 0, 0}, {values, 1, 0});
  }

  HostServices services_{nullptr, stamp_services(read_vdb)};
  const burin_vdb_stamps* vdb_ = service_of(services_);
  burin_vdb_stamp stamp_{};
  burin_vdb_info info_{};
  std::array<char, 300> text_{};
};

TEST_F(VdbStampService, SamplesDistancesInTheUnitOfThePlaces) {
  ASSERT_EQ(open(rail.c_str()), BURIN_OK) << text_.data();
  EXPECT_EQ(info_.kind, BURIN_VDB_LEVEL_SET);
  EXPECT_EQ(info_.size[0], 32u);
  EXPECT_NEAR(info_.maximum, 3, 1e-6);
  std::vector<float> x, scaled, values(2000), of_scaled(2000);
  for (int i = 0; i < 2000; ++i) x.push_back(0.1F * static_cast<float>(i) - 100);
  for (const float place : x) scaled.push_back(0.01F * place);
  ASSERT_EQ(sample(2000, x.data(), values.data()), BURIN_OK);
  ASSERT_EQ(sample(2000, scaled.data(), of_scaled.data(), 0.01F), BURIN_OK);
  float least = 9, most = -9;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(of_scaled[i], 0.01F * values[i], 1e-6F);
    const std::size_t period_on = std::min(i + 320, values.size() - 1);
    if (period_on == i + 320) {
      EXPECT_NEAR(values[i], values[period_on], 2e-4F);
    }
    least = std::min(least, values[i]);
    most = std::max(most, values[i]);
  }
  EXPECT_LT(least, -1);
  EXPECT_GT(most, 1);
}

TEST_F(VdbStampService, GoesByTheStrides) {
  ASSERT_EQ(open(rail.c_str()), BURIN_OK);
  constexpr std::size_t count = 200, stride = 2, stride_of_values = 3;
  std::vector<float> x, apart, values(count), expected(stride_of_values * count);
  for (std::size_t i = 0; i < count; ++i) {
    x.push_back(0.8F * static_cast<float>(i));
    apart.insert(apart.end(), {x.back(), -1.F});
  }
  ASSERT_EQ(sample(count, x.data(), values.data()), BURIN_OK);
  EXPECT_LT(std::ranges::min(values), std::ranges::max(values));
  std::vector<float> into(expected.size());
  const float voxel = 1, middle = static_cast<float>(info_.size[1]) / 2, up = 0.4F * middle;
  ASSERT_EQ(vdb_->sample(services_.abi(), stamp_, count, {&voxel, 0, 0}, {apart.data(), stride, 0},
                         {&middle, 0, 0}, {&up, 0, 0}, {into.data(), stride_of_values, 0}),
            BURIN_OK);
  for (std::size_t i = 0; i < count; ++i) expected[stride_of_values * i] = values[i];
  EXPECT_EQ(into, expected);
}

TEST_F(VdbStampService, SamplesOnManyThreads) {
  ASSERT_EQ(open(rail.c_str()), BURIN_OK);
  std::vector<float> x(20000), values(20000), expected(20000);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<float>(i) * 0.37F;
  ASSERT_EQ(sample(20000, x.data(), expected.data()), BURIN_OK);
  parallel_blocks(x.size(), 100, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(sample(static_cast<std::uint32_t>(end - begin), &x[begin], &values[begin]), BURIN_OK);
  });
  EXPECT_EQ(values, expected);
}

TEST_F(VdbStampService, RepeatsOnlyAlongThePeriodicAxes) {
  ASSERT_EQ(open(rail.c_str(), 0), BURIN_OK);
  const std::array<float, 2> x{16, 16 + 320};
  std::array<float, 2> values{};
  ASSERT_EQ(sample(2, x.data(), values.data()), BURIN_OK);
  EXPECT_GT(values[1], 300);
  const burin_vdb_stamp once = stamp_;
  ASSERT_EQ(open(rail.c_str()), BURIN_OK);
  EXPECT_NE(stamp_.handle, once.handle);
  ASSERT_EQ(sample(2, x.data(), values.data()), BURIN_OK);
  EXPECT_NEAR(values[0], values[1], 1e-4);
}

TEST_F(VdbStampService, RefusesWhatItCannotSample) {
  EXPECT_EQ(open("/no/such.vdb"), BURIN_ERROR);
  EXPECT_EQ(std::string(text_.data()).find("/no/such.vdb"), 0u) << text_.data();
  EXPECT_EQ(open(rail.c_str(), 0, "other"), BURIN_ERROR);
  EXPECT_EQ(std::string(text_.data()), rail + ": has no grid of floats named 'other'");
  EXPECT_EQ(open(nullptr), BURIN_INVALID_ARGUMENT);
  ASSERT_EQ(open(rail.c_str()), BURIN_OK);
  float x = std::numeric_limits<float>::quiet_NaN(), value = 0;
  EXPECT_EQ(sample(1, &x, &value), BURIN_INVALID_ARGUMENT);
  x = 1;
  EXPECT_EQ(sample(1, &x, &value, 0), BURIN_INVALID_ARGUMENT);
  vdb_->close(services_.abi(), stamp_);
  EXPECT_EQ(sample(1, &x, &value), BURIN_NOT_FOUND);
}

TEST(StampServices, HaveNoVdbStampsWithoutAReader) {
  const HostServices services(nullptr, stamp_services());
  EXPECT_EQ(service_of(services), nullptr);
}

}  // namespace
}  // namespace burin
