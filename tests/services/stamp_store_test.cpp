#include <burin/services/stamp_store.h>
#include <gtest/gtest.h>

#include <string>

#include "support/error_of.h"
#include "support/shared_data.h"

namespace burin {
namespace {

constexpr const char* stored_rock = "stamps/Rock035_height_1024_half_zip.exr";

TEST(StampStore, HoldsAFileOnceUntilItsLastClose) {
  BURIN_SHARED_DATA_OR_SKIP(path, stored_rock);
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

TEST(StampStore, HoldsAFileApartForOtherOptions) {
  BURIN_SHARED_DATA_OR_SKIP(path, stored_rock);
  StampStore store;
  const std::uint64_t tile = store.open(path).handle,
                      single = store.open(path, {.wrap_u = Wrap::black}).handle;
  EXPECT_NE(tile, single);
  EXPECT_EQ(store.open(path, {.wrap_u = Wrap::black}).handle, single);
  EXPECT_EQ(store.find(tile)->stamp().wrap_u, Wrap::periodic);
  EXPECT_EQ(store.find(single)->stamp().wrap_u, Wrap::black);
  EXPECT_EQ(store.find(single)->stamp().wrap_v, Wrap::periodic);
}

TEST(StampStore, HoldsImagesOfNoFile) {
  StampStore store;
  const StampImage image{2, 2, 1, {1, 2, 3, 4}, 1, 4};
  const std::uint64_t first = store.add(image), second = store.add(image);
  EXPECT_NE(first, second);
  EXPECT_EQ(store.find(first)->stamp().texels, image.texels);
  EXPECT_EQ(store.find(first)->levels.size(), 2u);
  store.close(first);
  EXPECT_EQ(store.find(first), nullptr);
  EXPECT_NE(store.find(second), nullptr);
}

TEST(StampStore, HoldsAsManyAsItSays) {
  StampStore store;
  const StampImage image{1, 1, 1, {1}, 1, 1};
  for (std::size_t i = 1; i < StampStore::capacity; ++i) store.add(image);
  const std::uint64_t last = store.add(image);
  EXPECT_EQ(test::error_of([&] { store.add(image); }), "more than 256 stamps open at once");
  store.close(last);
  EXPECT_NE(store.add(image), last);
}

TEST(StampStore, CountsWhatItFilled) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_BrightRingsNanInf.exr");
  StampStore store;
  EXPECT_EQ(store.open(path, {.clean = true}).filled, 18u);
  EXPECT_EQ(store.open(path, {.clean = true}).filled, 0u) << "said once";
}

}  // namespace
}  // namespace burin
