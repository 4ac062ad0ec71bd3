#include <burin/stamp/wrap.h>
#include <gtest/gtest.h>

#include <vector>

namespace burin {
namespace {

std::vector<std::ptrdiff_t> row(Wrap wrap) {
  std::vector<std::ptrdiff_t> indices;
  for (std::ptrdiff_t i = -7; i < 10; ++i) indices.push_back(wrapped_index(i, 3, wrap));
  return indices;
}

TEST(Wrap, FindsTheTexelThatStandsBeyondTheBorder) {
  using Row = std::vector<std::ptrdiff_t>;
  EXPECT_EQ(row(Wrap::periodic), (Row{2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0}));
  EXPECT_EQ(row(Wrap::mirror), (Row{0, 0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1, 2, 2}));
  EXPECT_EQ(row(Wrap::clamp), (Row{0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(row(Wrap::black), (Row{-1, -1, -1, -1, -1, -1, -1, 0, 1, 2, -1, -1, -1, -1, -1, -1, -1}));
}

TEST(Wrap, IsNamedAsTextureFilesNameIt) {
  for (const Wrap wrap : {Wrap::periodic, Wrap::mirror, Wrap::clamp, Wrap::black})
    EXPECT_EQ(parse_wrap(wrap_name(wrap)), wrap);
  EXPECT_EQ(wrap_name(Wrap::clamp), "clamp");
  EXPECT_EQ(parse_wrap("Clamp"), Wrap::unknown);
  EXPECT_EQ(parse_wrap(""), Wrap::unknown);
}

}  // namespace
}  // namespace burin
