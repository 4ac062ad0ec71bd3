#include "layout.h"

#include <gtest/gtest.h>

#include <set>
#include <span>
#include <string>

namespace burin {
namespace {

static_assert(sizeof(void*) == 8);
#define ASSERT_STRUCT(type, bytes) static_assert(sizeof(type) == (bytes), #type);
#define ASSERT_MEMBER(type, member, offset) \
  static_assert(offsetof(type, member) == (offset), #type "." #member);
BURIN_ABI_LAYOUT(ASSERT_STRUCT, ASSERT_MEMBER)

#define STRUCT_LINE(type, bytes) {#type, "", sizeof(type)},
#define MEMBER_LINE(type, member, offset) {#type, #member, offsetof(type, member)},
constexpr layout_line lines_in_cpp[] = {BURIN_ABI_LAYOUT(STRUCT_LINE, MEMBER_LINE)};

std::span<const layout_line> lines_in_c() {
  std::size_t count = 0;
  const layout_line* lines = burin_layout_in_c(&count);
  return {lines, count};
}

TEST(Layout, IsTheSameInCAndCpp) {
  const auto in_c = lines_in_c();
  ASSERT_EQ(in_c.size(), std::size(lines_in_cpp));
  for (std::size_t i = 0; i < in_c.size(); ++i) {
    EXPECT_STREQ(in_c[i].type, lines_in_cpp[i].type);
    EXPECT_STREQ(in_c[i].member, lines_in_cpp[i].member);
    EXPECT_EQ(in_c[i].bytes, lines_in_cpp[i].bytes) << in_c[i].type << "." << in_c[i].member;
  }
}

TEST(Layout, PutsStructSizeFirstUnlessFrozen) {
  const std::set<std::string> frozen = {"burin_floats",      "burin_indices", "burin_floats_out",
                                        "burin_stamp_area",  "burin_vectors", "burin_colours",
                                        "burin_param_value", "burin_stamp",   "burin_vdb_stamp"};
  const auto lines = lines_in_c();
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (*lines[i].member) continue;
    EXPECT_EQ(std::string(lines[i + 1].member) == "struct_size", !frozen.contains(lines[i].type))
        << lines[i].type;
  }
}

TEST(BurinHas, IsTrueFromTheLastByteOfTheMemberOn) {
  burin_stroke_plan plan = {};
  for (const std::uint32_t size : {0u, 4u, 8u, 15u}) {
    plan.struct_size = size;
    EXPECT_FALSE(BURIN_HAS(&plan, burin_stroke_plan, end_influence)) << size;
    EXPECT_EQ(BURIN_HAS(&plan, burin_stroke_plan, passes), size >= 8) << size;
  }
  plan.struct_size = 16;
  EXPECT_TRUE(BURIN_HAS(&plan, burin_stroke_plan, end_influence));
}

}  // namespace
}  // namespace burin
