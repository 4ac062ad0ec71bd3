#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../run_command.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

std::string stock(const std::string& name) {
  return (fs::path(BURIN_COMMAND).parent_path() / "brushes" / name).string();
}

TEST(BenchBrush, ComparesABrushWithItselfAndTheStockBrushes) {
  // A copy is another module for the system, with the same code.
  const CommandFolder folder;
  fs::copy_file(stock("wave.burin"), folder.path("copy.burin"));
  const nlohmann::json found = burin_json(
      {"bench-brush", stock("wave.burin"), "--against", folder.path("copy.burin"), "--rounds", "15"});
  ASSERT_EQ(found.size(), 1u);
  const nlohmann::json& wave = found[0];
  EXPECT_EQ(wave["brush"], "org.burin.wave");
  EXPECT_GT(wave["copies"]["low"], 0.1);
  EXPECT_LE(wave["copies"]["low"], wave["copies"]["value"]);
  // The same code: the order of magnitude holds whatever else the machine does.
  EXPECT_LT(wave["against"]["low"], 4);
  EXPECT_GT(wave["against"]["high"], 0.25);
  EXPECT_LE(wave["against"]["low"], wave["against"]["high"]);
  EXPECT_GT(wave["stock"].size(), 10u);
  EXPECT_GT(wave["share_of_event"], 0.0);
  EXPECT_LT(wave["share_of_event"], 1.0);
}

TEST(BenchBrush, FailsWhereABudgetIsExceeded) {
  const ProcessResult result = burin({"bench-brush", bad_plugin("speed.budget"), "--rounds", "5"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("org.example.good takes longer than its budget of"), std::string::npos)
      << result.err;
  EXPECT_NE(result.out.find("exceeded"), std::string::npos) << result.out;
}

TEST(BenchBrush, WritesAPageWithThePicture) {
  const CommandFolder folder;
  const std::string report = folder.path("page");
  EXPECT_EQ(burin({"bench-brush", bad_plugin("good"), "--rounds", "5", "--report", report}).exit_code, 0);
  EXPECT_GT(fs::file_size(report + "/org.example.good.png"), 10000u);
  std::stringstream page;
  page << std::ifstream(report + "/index.html").rdbuf();
  EXPECT_NE(page.str().find("<img src='org.example.good.png'"), std::string::npos);
  EXPECT_NE(page.str().find(">org.burin.groove</text>"), std::string::npos);
}

TEST(BenchBrush, RefusesWhatIsNoPlugin) {
  const CommandFolder folder;
  EXPECT_EQ(burin({"bench-brush", folder.write("a.burin", "text")}).exit_code, 2);
}

}  // namespace
}  // namespace burin::test
