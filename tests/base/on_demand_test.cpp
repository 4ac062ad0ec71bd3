#include <burin/base/on_demand.h>
#include <burin/base/parallel.h>
#include <gtest/gtest.h>

#include <array>

namespace burin {
namespace {

TEST(OnDemand, HasWhatWasPutUntilItIsForgotten) {
  OnDemand<int> squares;
  squares.restart(1000);
  EXPECT_EQ(squares.find(999), nullptr);
  for (const std::size_t i : {0, 3, 255, 256, 999}) squares.put(i, static_cast<int>(i * i));
  EXPECT_EQ(*squares.find(255), 255 * 255);
  EXPECT_EQ(*squares.find(999), 999 * 999);
  EXPECT_EQ(squares.find(4), nullptr);
  squares.forget_if([](int square) { return square > 255 * 255; });
  EXPECT_EQ(*squares.find(255), 255 * 255);
  EXPECT_EQ(squares.find(256), nullptr);
  squares.put(256, 7);
  EXPECT_EQ(*squares.find(256), 7);
  squares.restart(10);
  EXPECT_EQ(squares.find(3), nullptr);
}

TEST(OnDemand, KeepsOneOfTheValuesThatThreadsPutAtOnce) {
  OnDemand<std::array<std::size_t, 8>> values;
  values.restart(20000);
  parallel_blocks(80000, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::array<std::size_t, 8> value{};
      value.fill(i % 20000);
      if (!values.find(i % 20000)) values.put(i % 20000, value);
    }
  });
  for (std::size_t i = 0; i < 20000; ++i) {
    ASSERT_NE(values.find(i), nullptr);
    for (const std::size_t element : *values.find(i)) ASSERT_EQ(element, i);
  }
}

}  // namespace
}  // namespace burin
