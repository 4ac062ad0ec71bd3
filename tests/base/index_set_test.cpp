#include <burin/base/index_set.h>
#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <set>

namespace burin {
namespace {

TEST(IndexSet, DrainsWhatWasInsertedAscendingAndIsEmptyThen) {
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Index count : {1u, 64u, 4096u, 4097u, 100000u}) {
    IndexSet dirty(count);
    std::vector<Index> drained;
    for (int round = 0; round < 20; ++round) {
      std::set<Index> expected;
      for (int i = 0; i < round * 10; ++i) {
        const Index vertex = static_cast<Index>(random() % count);
        dirty.insert(vertex);
        expected.insert(vertex);
      }
      dirty.drain(drained);
      ASSERT_EQ(drained, std::vector<Index>(expected.begin(), expected.end())) << count;
    }
  }
}

TEST(IndexSet, HoldsTheLastVertex) {
  IndexSet dirty(8192);
  std::vector<Index> drained;
  dirty.insert(8191);
  dirty.insert(0);
  dirty.drain(drained);
  EXPECT_EQ(drained, (std::vector<Index>{0, 8191}));
}

}  // namespace
}  // namespace burin
