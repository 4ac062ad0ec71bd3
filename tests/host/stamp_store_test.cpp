#include "sessions.h"
#include "support/shared_data.h"

#include <burin/abi/ext/stamps.h>
#include <burin/base/parallel.h>
#include <burin/host/services.h>
#include <burin/host/stamp_store.h>

#include <array>
#include <limits>

namespace burin {
namespace {

constexpr const char* rock = "stamps/Rock035_height_1024_half_zip.exr";

TEST(StampStore, HoldsAFileOnceUntilItsLastClose) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  StampStore store;
  const std::uint64_t first = store.open(path).handle,
                      second = store.open(path.parent_path() / "." / path.filename()).handle;
  EXPECT_NE(first, 0u);
  EXPECT_EQ(store.find(first), store.find(second));
  EXPECT_EQ(store.find(first)->stamp().width, 1024);
  store.close(first);
  EXPECT_NE(store.find(second), nullptr);
  store.close(second);
  EXPECT_EQ(store.find(second), nullptr);
  store.close(second);
  EXPECT_NE(store.open(path).handle, second) << "a handle is not used twice";
  EXPECT_EQ(store.find(second), nullptr);
  EXPECT_EQ(store.find(0), nullptr);
}

TEST(StampStore, SaysWhyAFileCannotBeRead) {
  StampStore store;
  EXPECT_EQ(test::error_of([&] { store.open("/no/such/stamp.exr"); }).find("/no/such/stamp.exr: "), 0u);
}

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

  HostServices services_{nullptr};
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

TEST_F(StampService, RefusesWhatItCannotSample) {
  float place = 0.5f, value = 0, nowhere = std::numeric_limits<float>::infinity();
  EXPECT_EQ(sample(0, 1, &place, &place, &value), BURIN_NOT_FOUND);
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  ASSERT_EQ(open(path.c_str()), BURIN_OK);
  EXPECT_EQ(sample(0, 1, &place, &place, &value), BURIN_OK);
  EXPECT_EQ(sample(99, 1, &place, &place, &value), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(sample(0, 1, &nowhere, &place, &value), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(sample(0, 1, &place, &nowhere, &value), BURIN_INVALID_ARGUMENT);
}

TEST_F(StampService, CutsItsTextToTheBuffer) {
  EXPECT_EQ(open("/no/such/stamp.exr"), BURIN_ERROR);
  EXPECT_STREQ(text_.data(), "/no/such/stamp.exr:");
  EXPECT_EQ(open(nullptr), BURIN_INVALID_ARGUMENT);
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
