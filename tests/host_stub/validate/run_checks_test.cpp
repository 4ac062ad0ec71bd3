// What is told of plugins whose one fault makes several checks fail.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "validate_reports.h"

namespace burin::test {
namespace {

TEST(ValidateCommand, WaitsOnceForABrushThatHangs) {
  const nlohmann::json found = report(bad_plugin("several.always-hangs"), "2");
  EXPECT_EQ(failed_checks(found), Names{"life.begin-default"});
  std::map<std::string, int> verdicts;
  for (const auto& check : found["checks"]) ++verdicts[check["verdict"]];
  EXPECT_EQ(verdicts["TIMEOUT"], 1);
  EXPECT_GT(verdicts["SKIP"], 30);
  EXPECT_GT(verdicts["PASS"], 10) << "what looks at the module and its descriptors";
}

TEST(ValidateCommand, TellsOneFailureOfABrushThatWritesFarBeyondItsArrays) {
  expect_one_failure("several.writes-far", "memory.writes-within");
}

TEST(ValidateCommand, TellsOneFailureOfATableOfParametersThatEndsTooEarly) {
  expect_one_failure("several.param-count", "descriptor.param-ids");
}

TEST(ValidateCommand, TellsOneFailureOfADefaultThatIsRefused) {
  const nlohmann::json found = expect_one_failure("several.default-outside", "descriptor.param-defaults");
  EXPECT_EQ(text_of(found, "life.begin-default"), "a default cannot be right, see descriptor.param-defaults");
}

TEST(ValidateCommand, TellsOneFailureWhereABrushNeverDraws) {
  for (const char* brush : {"error_brush", "crashing_brush"}) {
    const nlohmann::json found = report(fmt::format("{}/{}.burin", BURIN_TEST_PLUGINS, brush), "4");
    EXPECT_EQ(failed_checks(found), Names{"life.begin-default"}) << brush;
    EXPECT_EQ(text_of(found, "life.begin-random"),
              "a brush does not draw with its defaults, see life.begin-default");
  }
}

TEST(ValidateCommand, SkipsComparisonsOfABrushThatDrawsOtherwiseEachTime) {
  const nlohmann::json found = report(bad_plugin("repeat.runs.cpp"), "2");
  EXPECT_EQ(failed_checks(found), Names{"repeat.runs"});
  EXPECT_EQ(text_of(found, "evaluate.stride-zero"), "a brush draws otherwise each time, see repeat.runs");
}

TEST(ValidateCommand, TellsOneFailureWhereLargeBatchesHaveNoRoom) {
  const nlohmann::json found = expect_one_failure("evaluate.batch-sizes.cpp", "evaluate.batch-sizes");
  EXPECT_EQ(text_of(found, "evaluate.batch-sizes"),
            "org.example.good: crashes with a batch of 4096 nodes; hosts may pass any number");
  EXPECT_EQ(text_of(found, "repeat.split"),
            "a brush crashes with some sizes of batches, see evaluate.batch-sizes");
}

}  // namespace
}  // namespace burin::test
