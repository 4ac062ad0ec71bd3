#include <burin/plugin/detail/error.h>
#include <gtest/gtest.h>

#include <string>

#include "plugin/driver.h"

namespace burin {
namespace {

enum Where { in_evaluate, in_begin };
enum What { runtime_error, bad_alloc, number, not_found };

class Throwing : public testing::Test {
 protected:
  test::PluginModule module_{"test-plugins/throwing_brush"};
  test::TestHost host_;
  test::StrokeDriver stroke_{module_, "org.burin.test.throwing", host_.abi};

  test::Answer answer(Where where, What what) {
    stroke_.end();
    stroke_.params.set("where", where);
    stroke_.params.set("what", what);
    const test::Answer begun = stroke_.begin();
    return where == in_begin ? begun : stroke_.evaluate({{1, 2}, {0, 0}});
  }
};

TEST_F(Throwing, BecomesAStatusAndATextOfOneLine) {
  for (const Where where : {in_evaluate, in_begin}) {
    SCOPED_TRACE(where);
    EXPECT_EQ(answer(where, runtime_error).status, BURIN_ERROR);
    EXPECT_EQ(answer(where, runtime_error).text, "thrown by the brush");
    EXPECT_EQ(answer(where, bad_alloc).status, BURIN_OUT_OF_MEMORY);
    EXPECT_EQ(answer(where, number).status, BURIN_ERROR);
    EXPECT_EQ(answer(where, number).text, "the brush threw something that is no std::exception");
    EXPECT_EQ(answer(where, not_found).status, BURIN_NOT_FOUND);
    EXPECT_EQ(answer(where, not_found).text, "gone");
  }
}

TEST_F(Throwing, CutsTheTextToTheHostsBuffer) {
  stroke_.text_capacity = 7;
  EXPECT_EQ(answer(in_evaluate, runtime_error).text, "thrown");
  stroke_.text_capacity = 0;
  EXPECT_EQ(answer(in_evaluate, runtime_error).status, BURIN_ERROR);
}

TEST(ErrorBrush, FailsWithItsText) {
  const test::PluginModule module("test-plugins/error_brush");
  const test::TestHost host;
  test::StrokeDriver stroke(module, "org.burin.test.error", host.abi);
  ASSERT_EQ(stroke.begin().status, BURIN_OK);
  const test::Answer answer = stroke.evaluate({{1}, {0}});
  EXPECT_EQ(answer.status, BURIN_ERROR);
  EXPECT_EQ(answer.text, "the error brush never works");
}

std::string written(std::string_view line, std::uint32_t capacity,
                    std::uint32_t struct_size = sizeof(burin_text)) {
  std::string buffer(20, '#');
  burin_text text{struct_size, capacity, buffer.data()};
  plugin::write_text(&text, line);
  return buffer.substr(0, capacity + 1);
}

TEST(WriteText, EndsTheTextWithinTheBuffer) {
  using namespace std::string_literals;
  EXPECT_EQ(written("abcdef", 7), "abcdef\0#"s);
  EXPECT_EQ(written("abcdef", 6), "abcde\0#"s);
  EXPECT_EQ(written("abcdef", 1), "\0#"s);
  EXPECT_EQ(written("abcdef", 0), "#");
}

TEST(WriteText, CutsBetweenCharacters) {
  EXPECT_STREQ(written("a\u00e9\u20ac", 7).c_str(), "a\u00e9\u20ac");
  EXPECT_STREQ(written("a\u00e9\u20ac", 6).c_str(), "a\u00e9");
  EXPECT_STREQ(written("a\u00e9\u20ac", 4).c_str(), "a\u00e9");
  EXPECT_STREQ(written("a\u00e9\u20ac", 3).c_str(), "a");
}

TEST(WriteText, LeavesATextAloneThatTheHostDidNotFill) {
  EXPECT_EQ(written("abc", 5, offsetof(burin_text, data)), "######");
  plugin::write_text(nullptr, "abc");
}

}  // namespace
}  // namespace burin
