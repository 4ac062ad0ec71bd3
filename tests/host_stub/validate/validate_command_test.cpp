#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "validate_reports.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

TEST(ValidateCommand, RunsTheChecksThatAreNamed) {
  const std::string good = bad_plugin("good");
  const auto names = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"validate", good, "--json"});
    std::vector<std::string> run;
    const nlohmann::json found = burin_json(options);
    for (const auto& check : found["checks"]) run.push_back(check["name"]);
    return run;
  };
  const std::vector<std::string> both = {"module.loads", "shape.seam"};
  EXPECT_EQ(names({"--only", "shape.seam,module.loads"}), both);
  EXPECT_EQ(names({"--only", "shape.seam", "--only", "module.loads", "--only", "shape.seam"}), both);
}

TEST(ValidateCommand, ChecksWithValuesOfParameters) {
  const std::string module = bad_plugin("life.optional-files");
  const ProcessResult result =
      burin({"validate", module, "--param", "file=any name", "--only", "life.begin-default"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("--only life.begin-default --seed 1 --param 'file=any name'\n"),
            std::string::npos)
      << result.out;
  EXPECT_EQ(
      burin({"validate", bad_plugin("good"), "--param", "height=0.5", "--param", "profile=flat"}).exit_code,
      0);
}

TEST(ValidateCommand, RefusesValuesThatParametersCannotHave) {
  const std::string good = bad_plugin("good");
  const auto refusal = [&](const std::string& param) {
    const ProcessResult result = burin({"validate", good, "--param", param});
    EXPECT_EQ(result.exit_code, 2) << param;
    return result.err;
  };
  EXPECT_NE(refusal("heigth=1").find("no brush of " + good + " has a parameter 'heigth'"), std::string::npos);
  EXPECT_NE(refusal("height=7").find("parameter 'height' of org.example.good: 7 is above the maximum 1"),
            std::string::npos);
  EXPECT_NE(refusal("height").find("takes NAME=VALUE"), std::string::npos);
}

TEST(ValidateCommand, RepeatsACheckByTheCommandThatItTells) {
  const ProcessResult all = burin({"validate", bad_plugin("shape.seam"), "--seed", "9"});
  EXPECT_EQ(all.exit_code, 1);
  EXPECT_NE(all.out.find("--only shape.seam --seed 9\n"), std::string::npos) << all.out;
  const ProcessResult one =
      burin({"validate", bad_plugin("shape.seam"), "--only", "shape.seam", "--seed", "9"});
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_NE(one.out.find("FAIL    shape.seam: org.example.good: a closed stroke has a step of"),
            std::string::npos)
      << one.out;
  EXPECT_TRUE(one.out.ends_with("0 passed, 1 failed, 0 skipped\n"));
}

TEST(ValidateCommand, TellsWhatPassed) {
  const std::string out = burin_output({"validate", bad_plugin("good")});
  EXPECT_NE(out.find("\nPASS    module.libraries: needs lib"), std::string::npos) << out;
  EXPECT_NE(out.find("\nPASS    module.symbol-versions: needs GLIBC_2."), std::string::npos) << out;
  EXPECT_NE(out.find("\nPASS    life.outside-values: begin takes some of height, count, profile\n"),
            std::string::npos)
      << out;
  const std::string stock =
      output_of(fs::path(BURIN_COMMAND).parent_path() / "brushes/groove.burin", "life.outside-values");
  EXPECT_TRUE(stock.starts_with("PASS    life.outside-values: begin refuses them\n")) << stock;
}

TEST(ValidateCommand, IsQuietIfItIsToBe) {
  EXPECT_EQ(
      burin_output({"validate", bad_plugin("good"), "--level", "1", "--quiet"}).find(" passed, 0 failed"),
      2u);
}

TEST(ValidateCommand, TellsNoLevelOfOneCheck) {
  EXPECT_EQ(burin_json({"validate", bad_plugin("good"), "--only", "shape.seam", "--json"})["level"], 0);
}

TEST(ValidateCommand, FailsOnWhatIsNoModule) {
  const CommandFolder folder;
  const ProcessResult result = burin({"validate", folder.write("text.burin", "not a library")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.out.starts_with("FAIL    module.loads: ")) << result.out;
}

TEST(ValidateCommand, NamesAFolderForTemporaryFilesThatIsNotThere) {
  const ProcessResult result =
      run_process({"env", "TMPDIR=/nowhere", BURIN_COMMAND, "validate", bad_plugin("good")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: /nowhere: is no folder for temporary files (TMPDIR)\n");
}

TEST(ValidateCommand, FailsWhereNothingWasTested) {
  EXPECT_EQ(burin({"validate", bad_plugin("good"), "--only", "ability.passes"}).exit_code, 1);
}

TEST(ValidateCommand, RefusesWrongUse) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"validate"},
                                                    {"validate", "/nowhere/a.burin"},
                                                    {"validate", bad_plugin("good"), "--only", "no.check"},
                                                    {"validate", bad_plugin("good"), "--only", ""},
                                                    {"validate", bad_plugin("good"), "--seed", "-1"},
                                                    {"validate", bad_plugin("good"), "--level", "6"}})
    EXPECT_EQ(burin(arguments).exit_code, 2);
}

TEST(ValidateCommand, WritesAJunitFileAndABadgeOfTheModule) {
  const CommandFolder folder;
  const std::string junit = folder.path("a.xml"), badge = folder.path("a.json");
  EXPECT_EQ(burin({"validate", bad_plugin("good"), "--level", "1", "--junit", junit, "--write-badge", badge})
                .exit_code,
            0);
  std::stringstream text;
  text << std::ifstream(junit).rdbuf();
  EXPECT_NE(text.str().find("<testcase classname=\"burin.validate\" name=\"module.loads\""),
            std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(badge))["level"], 1);
}

}  // namespace
}  // namespace burin::test
