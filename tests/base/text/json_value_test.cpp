#include <burin/base/text/json_value.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/shared_data.h"

namespace burin {
namespace {

using Reader = std::function<void(const JsonValue&)>;

/// What a reader says of the text of file "f"; empty when it takes it.
std::string complaint(
    const std::string& text, const Reader& read = [](const JsonValue&) {}) {
  try {
    read(JsonValue::parse(text, "f"));
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(JsonValue, NamesLineAndColumnOfWhatIsNoJson) {
  EXPECT_EQ(complaint("{}"), "");
  EXPECT_EQ(complaint(""), "f:1: malformed JSON at column 1");
  EXPECT_EQ(complaint("[1, 2"), "f:1: malformed JSON at column 6");
  EXPECT_EQ(complaint("{\"a\": 1,\n \"b\": oops}"), "f:2: malformed JSON at column 7");
  EXPECT_EQ(complaint("[1]\n\n[2]"), "f:3: malformed JSON at column 1");
  EXPECT_EQ(complaint(std::string("[1]\n\0[2]", 8)), "f:2: malformed JSON at column 1");
  EXPECT_EQ(complaint("[1e999]"), "f: a number is too large");
}

TEST(JsonValue, NamesTheLineThatItIs) {
  EXPECT_EQ(JsonValue::parse_line("[1, 2]", "f", 7).numbers(), (std::vector<double>{1, 2}));
  const auto line = [](const std::string& text) {
    try {
      JsonValue::parse_line(text, "f", 7).member("a").number();
    } catch (const MalformedJson& error) {
      return "malformed " + std::string(error.what());
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(line("{\"a\": }"), "malformed f:7: malformed JSON at column 7");
  EXPECT_EQ(line("{\"a\": true}"), "f:7: a: must be a number, not true");
  EXPECT_EQ(line("{\"a\": 1e999}"), "f:7: a number is too large");
}

TEST(JsonValue, NamesThePlaceAndTheValue) {
  const std::string text = R"({"cases": [{}, {"radius": "wide", "n": -1, "b\u0007": null}]})";
  const auto in_case = [&](const std::function<void(const JsonValue&)>& read) {
    return complaint(text, [&](const JsonValue& value) { read(value.member("cases").items()[1]); });
  };
  EXPECT_EQ(in_case([](const JsonValue& one) { one.member("radius").positive(); }),
            "f: cases[1].radius: must be a number above 0, not 'wide'");
  EXPECT_EQ(in_case([](const JsonValue& one) { one.member("n").positive(); }),
            "f: cases[1].n: must be a number above 0, not -1");
  EXPECT_EQ(in_case([](const JsonValue& one) { one.member("n").whole(0, 9); }),
            "f: cases[1].n: must be a whole number from 0 to 9, not -1");
  EXPECT_EQ(in_case([](const JsonValue& one) { one.member("b\a").text(); }),
            "f: cases[1].'b\\x07': must be a text, not null");
  EXPECT_EQ(in_case([](const JsonValue& one) { one.member("none"); }), "f: cases[1]: lacks 'none'");
  EXPECT_EQ(in_case([](const JsonValue& one) { one.number(); }), "f: cases[1]: must be a number");
  EXPECT_EQ(in_case([](const JsonValue& one) { one.member("n").boolean(); }),
            "f: cases[1].n: must be true or false, not -1");
  EXPECT_EQ(in_case([](const JsonValue& one) {
              one.member("radius").choice(std::map<std::string, int>{{"far", 1}, {"near", 2}});
            }),
            "f: cases[1].radius: must be one of far, near, not 'wide'");
  constexpr std::string_view known[] = {"radius", "n"};
  EXPECT_EQ(in_case([&](const JsonValue& one) { one.allow_only(known); }),
            "f: cases[1].'b\\x07': is not known");
}

TEST(JsonValue, NamesTheElementThatIsNoNumber) {
  const Reader numbers = [](const JsonValue& value) { value.numbers(); };
  EXPECT_EQ(complaint("[1, 2.5, -3]", numbers), "");
  EXPECT_EQ(complaint("[1, [2]]", numbers), "f: [1]: must be a number");
  EXPECT_EQ(complaint("[1, \"2\"]", numbers), "f: [1]: must be a number, not '2'");
  EXPECT_EQ(complaint("3", numbers), "f: must be an array of numbers, not 3");
}

TEST(JsonValue, KeepsTheContentAsLongAsAPartOfIt) {
  const auto last = [] { return JsonValue::parse(R"([1, {"a": [2, 3]}])", "f").items()[1].member("a"); }();
  EXPECT_EQ(last.numbers(), (std::vector<double>{2, 3}));
  EXPECT_EQ(last.size(), 2u);
  EXPECT_EQ(last.number_at(1), 3);
}

TEST(JsonValue, NamesAFileThatIsNotThere) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(JsonValue::read(folder.path() / "none.json"), FileError);
}

}  // namespace
}  // namespace burin
