#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../run_command.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

/// The same code takes the same time. An interval of 95 % twice as wide misses it once in 600 times:
/// Student's distribution with nine degrees of freedom beyond 4.5.
void expect_one_within(const nlohmann::json& ratio) {
  const double middle = std::log(ratio["value"].get<double>());
  EXPECT_LE(2 * std::log(ratio["low"].get<double>()) - middle, 0) << ratio;
  EXPECT_GE(2 * std::log(ratio["high"].get<double>()) - middle, 0) << ratio;
}

TEST(BenchBrush, ComparesABrushThatComputesNextToNothingWithItselfAndTheStockBrushes) {
  // A copy is another module for the system, with the same code.
  const CommandFolder folder;
  fs::copy_file(bad_plugin("good"), folder.path("copy.burin"));
  const nlohmann::json found = burin_json(
      {"bench-brush", bad_plugin("good"), "--against", folder.path("copy.burin"), "--rounds", "1"});
  ASSERT_EQ(found.size(), 1u);
  const nlohmann::json& good = found[0];
  EXPECT_EQ(good["brush"], "org.example.good");
  EXPECT_GT(good["copies"]["low"], 0.1);
  EXPECT_LE(good["copies"]["low"], good["copies"]["value"]);
  expect_one_within(good["against"]);
  EXPECT_GT(good["stock"].size(), 10u);
  EXPECT_GT(good["share_of_event"], 0.0);
  EXPECT_LT(good["share_of_event"], 1.0);
}

TEST(BenchBrush, FailsWhereABudgetIsExceededAndWritesAPageWithThePicture) {
  const CommandFolder folder;
  const std::string report = folder.path("page");
  const ProcessResult result =
      burin({"bench-brush", bad_plugin("speed.budget"), "--rounds", "1", "--report", report});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("org.example.good takes longer than its budget of"), std::string::npos)
      << result.err;
  EXPECT_NE(result.out.find("exceeded"), std::string::npos) << result.out;
  EXPECT_GT(fs::file_size(report + "/org.example.good.png"), 10000u);
  std::stringstream page;
  page << std::ifstream(report + "/index.html").rdbuf();
  EXPECT_NE(page.str().find("<img src='org.example.good.png'"), std::string::npos);
  EXPECT_NE(page.str().find(">org.burin.groove</text>"), std::string::npos);
}

TEST(BenchBrush, TellsTheBudgetThatABrushStatesInItsInfo) {
  const fs::path groove = fs::path(BURIN_COMMAND).parent_path() / "brushes" / "groove.burin";
  const ProcessResult result = burin({"bench-brush", groove, "--rounds", "1", "--json"});
  // Whether it is kept depends on what the compiler was told.
  EXPECT_EQ(nlohmann::json::parse(result.out)[0]["budget"], 100) << result.err;
}

TEST(BenchBrush, TellsTheBudgetOfABrushInC) {
  const fs::path brush = fs::path(BURIN_TEST_PLUGINS).parent_path() / "test-brushes" / "budget_in_c.burin";
  const ProcessResult result = burin({"bench-brush", brush, "--rounds", "1", "--json"});
  EXPECT_EQ(nlohmann::json::parse(result.out)[0]["budget"], 12.5) << result.err;
}

TEST(BenchBrush, RefusesAnotherVersionThatHasOtherBrushes) {
  const std::string other = fs::path(BURIN_COMMAND).parent_path() / "brushes" / "groove.burin";
  const ProcessResult result =
      burin({"bench-brush", bad_plugin("good"), "--against", other, "--rounds", "1"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: " + other + ": has no brush of the same id that can be measured\n");
}

TEST(BenchBrush, RefusesWhatIsNoPlugin) {
  const CommandFolder folder;
  EXPECT_EQ(burin({"bench-brush", folder.write("a.burin", "text")}).exit_code, 2);
}

}  // namespace
}  // namespace burin::test
