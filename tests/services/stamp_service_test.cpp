#include <burin/abi/ext/stamps.h>
#include <burin/base/parallel.h>
#include <burin/host/plugin/services.h>
#include <burin/services/stamp_services.h>
#include <burin/stamp/area_filter.h>
#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/float_image.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "support/shared_data.h"

namespace burin {
namespace {

constexpr const char* rock = "stamps/Rock035_height_1024_half_zip.exr";

std::vector<std::string> logged;

/// The service as a plugin sees it.
class StampService : public ::testing::Test {
 protected:
  burin_status open(const char* path, burin_stamp_info* info = nullptr) {
    burin_text text{sizeof(burin_text), static_cast<std::uint32_t>(text_.size()), text_.data()};
    return stamps_->open(services_.abi(), path, &stamp_, info, &text);
  }
  burin_status sample(std::uint32_t channel, std::uint32_t count, const float* u, const float* v,
                      float* values) {
    return stamps_->sample(services_.abi(), stamp_, channel, count, {u, 1, 0}, {v, 1, 0}, {values, 1, 0});
  }

  burin_status open_with(const char* path, const burin_stamp_options& options,
                         burin_stamp_info* info = nullptr) {
    burin_text text{sizeof(burin_text), static_cast<std::uint32_t>(text_.size()), text_.data()};
    return stamps_->open_with(services_.abi(), path, &options, &stamp_, info, &text);
  }
  burin_status sample_area(std::uint32_t count, const float* u, const float* v, const burin_stamp_area& area,
                           float* values) {
    return stamps_->sample_area(services_.abi(), stamp_, 0, count, {u, 1, 0}, {v, 1, 0}, &area,
                                {values, 1, 0});
  }
  void SetUp() override { logged.clear(); }

  HostServices services_{[](int severity, std::string_view line) {
                           logged.emplace_back(std::to_string(severity) + " " + std::string(line));
                         },
                         stamp_services()};
  const burin_stamps* stamps_ =
      static_cast<const burin_stamps*>(services_.abi()->get_extension(services_.abi(), BURIN_EXT_STAMPS));
  burin_stamp stamp_{};
  std::array<char, 20> text_{};
};

TEST_F(StampService, SamplesOnManyThreads) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  burin_stamp_info info{};
  info.struct_size = sizeof(info);
  ASSERT_EQ(open(path.c_str(), &info), BURIN_OK);
  EXPECT_EQ(info.width, 1024u);
  EXPECT_LT(info.minimum, info.maximum);
  std::vector<float> u(20000), v(20000), values(20000);
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = static_cast<float>(i) * 0.37f;
    v[i] = -static_cast<float>(i) * 0.11f;
  }
  parallel_blocks(u.size(), 100, [&](std::size_t begin, std::size_t end) {
    sample(0, static_cast<std::uint32_t>(end - begin), &u[begin], &v[begin], &values[begin]);
  });
  const StampImage image = read_stamp(path);
  for (std::size_t i = 0; i < u.size(); ++i) ASSERT_EQ(values[i], sample_bilinear(image, 0, u[i], v[i]));
  stamps_->close(services_.abi(), stamp_);
}

TEST_F(StampService, TakesTheChannelAndTheZeroThatAreAskedFor) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path() / "rgb.exr";
  write_exr(path, {1, 1, {"R", "G", "B"}, {1, 2, 3}});
  burin_stamp_info info{};
  info.struct_size = sizeof(info);
  burin_stamp_options options{sizeof(options), BURIN_WRAP_BLACK, BURIN_WRAP_BLACK, 0, nullptr, "G", 0.5f, 0};
  ASSERT_EQ(open_with(path.c_str(), options, &info), BURIN_OK);
  EXPECT_EQ(info.channels, 1u);
  EXPECT_EQ(info.maximum, 1.5f);
  stamps_->close(services_.abi(), stamp_);
  options.layer = "none";
  EXPECT_EQ(open_with(path.c_str(), options), BURIN_ERROR);
  options = {
      offsetof(burin_stamp_options, layer), BURIN_WRAP_UNKNOWN, BURIN_WRAP_UNKNOWN, 0, "none", "G", 0.5f, 0};
  ASSERT_EQ(open_with(path.c_str(), options, &info), BURIN_OK);  // a version that knows of no layers
  EXPECT_EQ(info.channels, 3u);
  EXPECT_EQ(info.maximum, 1);
  stamps_->close(services_.abi(), stamp_);
  options = {sizeof(options),
             BURIN_WRAP_UNKNOWN,
             BURIN_WRAP_UNKNOWN,
             0,
             nullptr,
             nullptr,
             std::numeric_limits<float>::infinity(),
             0};
  EXPECT_EQ(open_with(path.c_str(), options), BURIN_INVALID_ARGUMENT);
}

TEST_F(StampService, RefusesWhatItCannotSample) {
  float place = 0.5f, value = 0, nowhere = std::numeric_limits<float>::infinity();
  EXPECT_EQ(sample(0, 1, &place, &place, &value), BURIN_NOT_FOUND);
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  ASSERT_EQ(open(path.c_str()), BURIN_OK);
  EXPECT_EQ(sample(0, 1, &place, &place, &value), BURIN_OK);
  EXPECT_EQ(sample(99, 1, &place, &place, &value), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(sample(0, 1, &nowhere, &place, &value), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(sample(0, 1, &place, &nowhere, &value), BURIN_INVALID_ARGUMENT);
  const burin_floats wide{&nowhere, 0, 0}, narrow{&place, 0, 0};
  EXPECT_EQ(sample_area(1, &place, &place, {narrow, narrow, narrow, narrow}, &value), BURIN_OK);
  EXPECT_EQ(sample_area(1, &place, &place, {wide, narrow, narrow, narrow}, &value), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(sample_area(1, &nowhere, &place, {narrow, narrow, narrow, narrow}, &value),
            BURIN_INVALID_ARGUMENT);
}

TEST_F(StampService, CutsItsTextToTheBuffer) {
  EXPECT_EQ(open("/no/such/stamp.exr"), BURIN_ERROR);
  EXPECT_STREQ(text_.data(), "/no/such/stamp.exr:");
  EXPECT_EQ(open(nullptr), BURIN_INVALID_ARGUMENT);
}

TEST_F(StampService, SamplesAreasOnManyThreads) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  ASSERT_EQ(open(path.c_str()), BURIN_OK);
  std::vector<float> u(20000), v(20000), long_u(20000), values(20000);
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = static_cast<float>(i) * 0.37f;
    v[i] = -static_cast<float>(i) * 0.11f;
    long_u[i] = static_cast<float>(i % 100) / 4000;
  }
  const float zero = 0, across = 0.004f;  // stride 0: one value for all
  parallel_blocks(u.size(), 100, [&](std::size_t begin, std::size_t end) {
    sample_area(static_cast<std::uint32_t>(end - begin), &u[begin], &v[begin],
                {{&long_u[begin], 1, 0}, {&zero, 0, 0}, {&zero, 0, 0}, {&across, 0, 0}}, &values[begin]);
  });
  const MipPyramid pyramid = make_mip_pyramid(read_stamp(path));
  for (std::size_t i = 0; i < u.size(); ++i)
    ASSERT_EQ(values[i], burin::sample_area(pyramid, 0, u[i], v[i], {long_u[i], 0, 0, across}));
  stamps_->close(services_.abi(), stamp_);
}

TEST_F(StampService, OpensAsTheOptionsSay) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  burin_stamp_info info{};
  info.struct_size = sizeof(info);
  burin_stamp_options options{
      sizeof(options), BURIN_WRAP_MIRROR, BURIN_WRAP_UNKNOWN, 0, nullptr, nullptr, 0, 0};
  ASSERT_EQ(open_with(path.c_str(), options, &info), BURIN_OK);
  EXPECT_EQ(info.wrap_u, BURIN_WRAP_MIRROR);
  EXPECT_EQ(info.wrap_v, BURIN_WRAP_PERIODIC);
  float at[] = {-0.25f, 0.25f}, v[] = {0.5f, 0.5f}, values[2];
  ASSERT_EQ(sample(0, 2, at, v, values), BURIN_OK);
  EXPECT_EQ(values[0], values[1]);
  options.wrap_v = 5;
  EXPECT_EQ(open_with(path.c_str(), options), BURIN_INVALID_ARGUMENT);
  options.wrap_v = -1;
  EXPECT_EQ(open_with(path.c_str(), options), BURIN_INVALID_ARGUMENT);
  options = {offsetof(burin_stamp_options, wrap_v), BURIN_WRAP_CLAMP, 99, 99, nullptr, nullptr, 0, 0};
  ASSERT_EQ(open_with(path.c_str(), options, &info), BURIN_OK) << "beyond the caller's struct";
  EXPECT_EQ(info.wrap_u, BURIN_WRAP_CLAMP);
  EXPECT_EQ(info.wrap_v, BURIN_WRAP_PERIODIC);
}

TEST_F(StampService, LogsWhatItCleaned) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_BrightRingsNanInf.exr");
  EXPECT_EQ(open(path.c_str()), BURIN_ERROR);
  const burin_stamp_options clean{
      sizeof(clean), BURIN_WRAP_UNKNOWN, BURIN_WRAP_UNKNOWN, 1, nullptr, nullptr, 0, 0};
  ASSERT_EQ(open_with(path.c_str(), clean), BURIN_OK);
  EXPECT_EQ(logged, std::vector<std::string>{"3 " + path.string() +
                                             ": filled 18 values that are not finite from their neighbours"});
}

TEST_F(StampService, FillsTheInfoThatTheCallerKnows) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  burin_stamp_info info{};
  info.struct_size = offsetof(burin_stamp_info, channels);
  ASSERT_EQ(open(path.c_str(), &info), BURIN_OK);
  EXPECT_EQ(info.height, 1024u);
  EXPECT_EQ(info.channels, 0u) << "beyond the caller's struct";
}

}  // namespace
}  // namespace burin
