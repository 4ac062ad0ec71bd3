#pragma once
#include <burin/chart/chart.h>
#include <gtest/gtest.h>

namespace burin::test {

/// Expects that two charts are equal bit for bit.
inline void expect_same(const Chart& a, const Chart& b) {
  EXPECT_EQ(a.vertex, b.vertex);
  EXPECT_EQ(a.sheet, b.sheet);
  EXPECT_EQ(a.stretch, b.stretch);
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.d, b.d);
  EXPECT_EQ(a.e1, b.e1);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.closed, b.closed);
}

}  // namespace burin::test
