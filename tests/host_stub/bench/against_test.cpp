#include <gtest/gtest.h>

#include "bench_suite.h"

namespace burin::test {
namespace {

using nlohmann::json;

struct Comparison {
  BenchFolder folder;
  std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b")});

  ProcessResult run(const std::string& other, const std::string& threshold) const {
    return burin({"bench", suite, "--against", other, "--rounds", "4", "--repeat", "2", "--threshold",
                  threshold, "--json"});
  }
};

TEST(BenchAgainst, FindsABuildAsFastAsItself) {
  const Comparison comparison;
  const ProcessResult result = comparison.run(BURIN_COMMAND, "3");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json all = json::parse(result.out);
  EXPECT_EQ(all["rounds"], 4);
  ASSERT_EQ(all["cases"].size(), 2u);
  for (const json& one : all["cases"]) {
    EXPECT_EQ(one["this_ms"].size(), 4u);
    EXPECT_EQ(one["other_ms"].size(), 4u);
    EXPECT_EQ(one["this_hash"], one["other_hash"]);
    EXPECT_LE(one["low"], one["ratio"]);
    EXPECT_LE(one["ratio"], one["high"]);
    EXPECT_GT(one["high"], 0.5);
    EXPECT_LT(one["low"], 2);
    EXPECT_EQ(one["verdict"], "ok");
  }
}

TEST(BenchAgainst, FailsWhereThisBuildIsSlower) {
  const Comparison comparison;
  // The other build's times of the strokes, told as a hundredth of a millisecond.
  const std::string fast = comparison.folder.changed_burin("/\"stroke_s\"/,/]/ s/[0-9][0-9.e-]*/0.00001/");
  const ProcessResult result = comparison.run(fast, "1.05");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err.rfind("burin: 2 of 2 cases are slower than 1.05 times", 0), 0u) << result.err;
  const json cases = json::parse(result.out)["cases"];
  EXPECT_EQ(cases.size(), 2u);
  for (const json& one : cases) {
    EXPECT_GT(one["low"], 2);
    EXPECT_EQ(one["verdict"], "slower");
  }
}

TEST(BenchAgainst, FailsWhereTheResultIsAnother) {
  const Comparison comparison;
  const std::string other = comparison.folder.changed_burin(
      "/\"name\": \"b\"/,/\"hash\"/ s/(\"hash\": \")[0-9a-f]+/\\10123456789abcdef/");
  const ProcessResult result = comparison.run(other, "1000");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_EQ(result.err.rfind("burin: 1 of 2 cases is ", 0), 0u) << result.err;
  const json cases = json::parse(result.out)["cases"];
  EXPECT_EQ(cases[0]["verdict"], "ok");
  EXPECT_EQ(cases[1]["verdict"], "another result");
  EXPECT_EQ(cases[1]["other_hash"], "0123456789abcdef");
  EXPECT_NE(cases[1]["this_hash"], cases[1]["other_hash"]);
}

TEST(BenchAgainst, FailsWhereRoundsOfABuildDiffer) {
  const Comparison comparison;
  const std::string restless =
      comparison.folder.changed_burin("s/(\"hash\": \")[0-9a-f]+/\\1'$$'/");  // the process's number
  const ProcessResult result = comparison.run(restless, "1000");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "burin: " + restless + ": case 'a' gave another result than a round before\n");
}

TEST(BenchAgainst, SaysWhatTheOtherBuildAnswered) {
  const Comparison comparison;
  const std::string mute = comparison.folder.changed_burin("d");
  const ProcessResult nothing = comparison.run(mute, "2");
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_EQ(nothing.err, "burin: " + mute + ":1: malformed JSON at column 1\n");
  EXPECT_EQ(comparison.run(comparison.folder.path("none"), "2").exit_code, 2);
  EXPECT_EQ(comparison.run(comparison.folder.path("suite.json"), "2").exit_code, 2) << "not a program";
}

}  // namespace
}  // namespace burin::test
