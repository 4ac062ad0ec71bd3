#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "../run_command.h"
#include "sanitizers/sanitized.h"
#include "validate/report.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The report of the checks of these levels; whatever they find.
nlohmann::json report(const std::string& module, const std::string& level) {
  return nlohmann::json::parse(burin({"validate", module, "--json", "--level", level}).out);
}

Names failed_checks(const nlohmann::json& report) {
  Names names;
  for (const auto& check : report["checks"])
    if (check["verdict"] != "PASS" && check["verdict"] != "SKIP") names.insert(check["name"]);
  return names;
}

/// What a report tells of a check; a failure of the test if it does not name it.
std::string text_of(const nlohmann::json& report, const std::string& name) {
  for (const auto& check : report["checks"])
    if (check["name"] == name) return check["text"];
  ADD_FAILURE() << "no check " << name;
  return {};
}

/// What one check of a module prints.
std::string output_of(const std::string& module, const std::string& check) {
  return burin({"validate", module, "--only", check}).out;
}

/// The names of all checks.
Names all_checks() {
  std::istringstream lines(burin_output({"validate", "--list"}));
  Names names;
  int level = 0;
  std::string name;
  for (std::string rest; lines >> level >> name && std::getline(lines, rest);) names.insert(name);
  return names;
}

/// The names of all plugins with a fault: that of their check, "shape.seam", and of those in C++ ".cpp".
Names bad_plugins() {
  Names names;
  for (const auto& entry : fs::directory_iterator(BURIN_BAD_PLUGINS)) names.insert(entry.path().stem());
  names.erase("good");
  return names;
}

std::string check_of(const std::string& plugin) {
  return plugin.ends_with(".cpp") ? plugin.substr(0, plugin.size() - 4) : plugin;
}

TEST(ValidateCommand, FindsNoFaultWhereThereIsNone) {
  const nlohmann::json found = report(bad_plugin("good"), "4");
  EXPECT_EQ(failed_checks(found), Names{});
  EXPECT_GT(found["passed"], 60);
  EXPECT_EQ(found["level"], 4);
}

TEST(ValidateCommand, HasAPluginWithAFaultForEachCheck) {
  Names in_c, in_cpp, missing;
  for (const std::string& plugin : bad_plugins())
    (plugin.ends_with(".cpp") ? in_cpp : in_c).insert(check_of(plugin));
  const Names checks = all_checks();
  std::set_difference(checks.begin(), checks.end(), in_c.begin(), in_c.end(),
                      std::inserter(missing, missing.end()));
  EXPECT_EQ(missing, Names{});
  EXPECT_GE(in_c.size(), 48u);
  // Compilers find the others in C++, or BURIN_PLUGIN has the code that could be wrong.
  EXPECT_GE(in_cpp.size(), 40u);
}

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
  const nlohmann::json found = report(bad_plugin("several.writes-far"), "4");
  EXPECT_EQ(failed_checks(found), Names{"memory.writes-within"});
}

TEST(ValidateCommand, TellsOneFailureOfATableOfParametersThatEndsTooEarly) {
  const nlohmann::json found = report(bad_plugin("several.param-count"), "4");
  EXPECT_EQ(failed_checks(found), Names{"descriptor.param-ids"});
}

TEST(ValidateCommand, TellsOneFailureOfADefaultThatIsRefused) {
  const nlohmann::json found = report(bad_plugin("several.default-outside"), "4");
  EXPECT_EQ(failed_checks(found), Names{"descriptor.param-defaults"});
  EXPECT_EQ(text_of(found, "life.begin-default"), "a default cannot be right, see descriptor.param-defaults");
}

TEST(ValidateCommand, FindsSoftRangesThatWereForgotten) {
  const nlohmann::json found = report(bad_plugin("several.soft-range"), "4");
  EXPECT_EQ(failed_checks(found), Names{"descriptor.param-ranges"});
  EXPECT_EQ(text_of(found, "descriptor.param-ranges"),
            "org.example.good: parameter 'count': its soft range, which a slider spans, is 0 .. 0");
}

TEST(ValidateCommand, EnlargesEachStructThatAHostFills) {
  const std::map<std::string, std::string> texts = {
      {"several.larger-host", "create fails with a larger burin_host: "},
      {"several.larger-solid", "fills a larger burin_solid_plan with something else"},
      {"several.larger-curve", "filter fails with burin_curve_points of another size"},
      {"several.larger-reach", "writes members of burin_curve_reach that there are not"}};
  for (const auto& [plugin, text] : texts) {
    const nlohmann::json found = report(bad_plugin(plugin), "4");
    EXPECT_EQ(failed_checks(found), Names{"host.newer"}) << plugin;
    EXPECT_EQ(text_of(found, "host.newer"), "org.example.good: " + text);
  }
}

TEST(ValidateCommand, TriesNoInfiniteValuesOfARangeWithoutAnEnd) {
  const nlohmann::json found = report(bad_plugin("several.endless-range"), "4");
  EXPECT_EQ(failed_checks(found), Names{"descriptor.param-ranges"});
  EXPECT_EQ(text_of(found, "descriptor.param-ranges"),
            "org.example.good: parameter 'height': its soft range is not finite");
}

TEST(ValidateCommand, LooksAfterAStrokeWhatAModuleLeaves) {
  const nlohmann::json file = report(bad_plugin("several.keeps-file"), "4");
  EXPECT_EQ(failed_checks(file), Names{"module.unloads"});
  EXPECT_EQ(text_of(file, "module.unloads"), "leaves a file open after its last deinit");
  const nlohmann::json loaded = report(bad_plugin("several.stays-loaded"), "4");
  EXPECT_EQ(failed_checks(loaded), Names{"module.unloads"});
  EXPECT_TRUE(text_of(loaded, "module.unloads").starts_with("stays in memory after it was unloaded"));
  for (int time = 0; time < 20; ++time)
    EXPECT_EQ(burin({"validate", bad_plugin("several.joins-thread"), "--only", "module.unloads"}).exit_code,
              0);
}

TEST(ValidateCommand, MeasuresTheRimSlopeFromTheRimToTheMiddle) {
  const nlohmann::json found = report(bad_plugin("several.rim-inside"), "4");
  EXPECT_EQ(failed_checks(found), Names{"shape.rim"});
}

TEST(ValidateCommand, FindsTheRimSlopesOfStockBrushesRightWithTheGreatestValues) {
  const std::map<std::string, std::vector<std::string>> greatest = {
      {"groove", {"depth=10", "profile=flat", "taper=0"}},
      {"crease", {"depth=10", "sharpness=32", "bulge=1", "pinch=1", "taper=0"}},
      {"pinch", {"amount=1", "lift=10"}},
      {"wave", {"height=10", "width=1"}}};
  for (const auto& [brush, values] : greatest) {
    const fs::path module = fs::path(BURIN_COMMAND).parent_path() / "brushes" / (brush + ".burin");
    std::vector<std::string> arguments = {"validate", module, "--only", "shape.rim"};
    for (const std::string& value : values) arguments.insert(arguments.end(), {"--param", value});
    EXPECT_EQ(burin_output(arguments), "PASS    shape.rim\n1 passed, 0 failed, 0 skipped\n") << brush;
  }
}

TEST(ValidateCommand, TellsOfABrushThatEndsTheProcess) {
  EXPECT_TRUE(output_of(bad_plugin("several.calls-exit"), "life.begin-default")
                  .starts_with("CRASH   life.begin-default: ended the process with exit code 0\n"));
}

TEST(ValidateCommand, TellsOfAFailureWithoutAText) {
  const nlohmann::json found = report(bad_plugin("several.no-text"), "4");
  EXPECT_EQ(failed_checks(found), Names{"host.text-capacity"});
  EXPECT_EQ(text_of(found, "host.text-capacity"), "create fails without a text");
}

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

TEST(ValidateCommand, DrawsWithRandomValuesWhateverTheSeed) {
  EXPECT_NE(burin({"validate", bad_plugin("life.begin-random"), "--only", "life.begin-random", "--seed",
                   "18446744073709551615"})
                .out.find("FAIL    life.begin-random"),
            std::string::npos);
}

TEST(ValidateCommand, TellsTheNodeAndTheOutput) {
  const std::string out = output_of(bad_plugin("life.begin-default"), "life.begin-default");
  EXPECT_TRUE(
      std::regex_search(out, std::regex("writes -?(nan|inf) to 'up' at t -?[0-9.]+ and d -?[0-9.]+\n")))
      << out;
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

TEST(ValidateCommand, SkipsWhatItCannotCountWhereASanitizerServesMemory) {
  std::string library = run_process({"g++", "-print-file-name=libasan.so"}).out;
  library.resize(library.find('\n'));
  const auto found = nlohmann::json::parse(
      run_process({"env", "LD_PRELOAD=" + library, "ASAN_OPTIONS=detect_leaks=0", BURIN_COMMAND, "validate",
                   bad_plugin("life.strokes-freed"), "--json"})
          .out);
  EXPECT_EQ(failed_checks(found), Names{});
  Names skipped;
  for (const auto& check : found["checks"])
    if (check["text"] == "malloc is replaced, by a sanitizer or a preloaded library")
      skipped.insert(check["name"]);
  EXPECT_EQ(skipped, (Names{"life.brushes-freed", "life.strokes-freed", "memory.allocations"}));
}

/// The checks that fail of a plugin with a fault, by its name: the one for it. Where this program and so the
/// command have the address sanitizer, that serves memory, which some checks count then no more, ends a
/// process that reads beyond an array before the check can tell, and overwrites memory that was freed.
Names checks_that_find(const std::string& plugin) {
  const std::string check = check_of(plugin);
  if (!test::sanitized) return {check};
  if (Names{"life.brushes-freed", "life.strokes-freed", "memory.allocations"}.contains(check)) return {};
  if (check == "memory.reads-within")
    return {"life.begin-default", "memory.reads-within", "memory.system-calls"};
  if (plugin == "process.lent") return {"life.two-brushes", "process.lent"};
  return {check};
}

class BadPlugins : public ::testing::TestWithParam<std::string> {};

TEST_P(BadPlugins, AreFoundByTheOneCheckOfTheirName) {
  for (const std::string& name : bad_plugins()) {
    if (name.substr(0, name.find('.')) != GetParam()) continue;
    const std::string check = check_of(name);
    const bool fast = check.starts_with("speed.") || check == "module.load-time";
    const Names failed = failed_checks(report(bad_plugin(name), fast ? "5" : "4"));
    // Whether a speed holds depends on what else this machine does.
    if (fast) {
      EXPECT_TRUE(failed.contains(check)) << name;
    } else {
      EXPECT_EQ(failed, checks_that_find(name)) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachTopic, BadPlugins,
                         ::testing::Values("module", "descriptor", "life", "host", "evaluate", "memory",
                                           "process", "shape", "repeat", "ability", "speed"),
                         [](const auto& topic) { return topic.param; });

TEST(ValidateCommand, FindsNoFaultInStockBrushes) {
  for (const auto& entry : fs::directory_iterator(fs::path(BURIN_COMMAND).parent_path() / "brushes"))
    if (entry.path().extension() == ".burin") {
      EXPECT_EQ(failed_checks(report(entry.path(), "4")), Names{}) << entry.path();
    }
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

TEST(ValidateCommand, TellsOneFailureWhereABrushNeverDraws) {
  for (const char* brush : {"error_brush", "crashing_brush"}) {
    const nlohmann::json found = report(fmt::format("{}/{}.burin", BURIN_TEST_PLUGINS, brush), "4");
    EXPECT_EQ(failed_checks(found), Names{"life.begin-default"}) << brush;
    EXPECT_EQ(text_of(found, "life.begin-random"),
              "a brush does not draw with its defaults, see life.begin-default");
  }
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

TEST(ValidateReport, ShowsTheFirstFailuresOnly) {
  using namespace validate;
  const std::vector<Result> results(5, {find_check("shape.seam"), Verdict::fail, "a step"});
  Subject subject;
  subject.module = "a.burin";
  const std::string text = short_report(subject, results);
  EXPECT_EQ(std::ranges::count(text, '\n'), 3 * 3 + 2) << text;
  EXPECT_NE(text.find("and 2 more failures: burin validate a.burin\n"), std::string::npos) << text;
}

TEST(ValidateCommand, IsQuietIfItIsToBe) {
  EXPECT_EQ(
      burin_output({"validate", bad_plugin("good"), "--level", "1", "--quiet"}).find(" passed, 0 failed"),
      2u);
}

TEST(ValidateReport, NamesTheClauseThatACallBreaksWhichDoesNotReturn) {
  using namespace validate;
  const std::vector<Result> results = {{find_check("shape.seam"), Verdict::timeout, "did not end"},
                                       {find_check("shape.seam"), Verdict::fail, "a step"}};
  Subject subject;
  subject.module = bad_plugin("good");
  const std::string late = "base.h: every call returns", step = find_check("shape.seam")->clause;
  const Json json = json_report(subject, results, 4);
  EXPECT_EQ(json["checks"][0]["clause"], late);
  EXPECT_EQ(json["checks"][1]["clause"], step);
  for (const std::string& text : {text_report(subject, results), junit_report(subject, results)}) {
    EXPECT_LT(text.find(late), text.find(step)) << text;
    EXPECT_NE(text.find(step), std::string::npos) << text;
  }
}

TEST(ValidateReport, TellsOfMemoryBeforeWhatComesOfIt) {
  using namespace validate;
  const std::vector<Result> results = {{find_check("life.two-brushes"), Verdict::crash, {}},
                                       {find_check("memory.writes-within"), Verdict::crash, {}}};
  Subject subject;
  subject.module = "a.burin";
  const std::string text = short_report(subject, results);
  EXPECT_TRUE(text.starts_with("CRASH   memory.writes-within\n")) << text;
  EXPECT_NE(text.find("CRASH   life.two-brushes\n"), std::string::npos) << text;
}

TEST(ValidateCommand, DrawsWithBrushesThatTakeNoImage) {
  const auto module = fs::path(BURIN_COMMAND).parent_path() / "brushes/vdb_trail.burin";
  EXPECT_GT(report(module, "4")["passed"], 60);
}

TEST(ValidateCommand, TellsWhereAModuleAllocates) {
  if (test::sanitized) GTEST_SKIP() << "a sanitizer serves malloc";
  const std::string module = bad_plugin("memory.allocations");
  const std::string out = output_of(module, "memory.allocations");
  std::smatch place;
  ASSERT_TRUE(
      std::regex_search(out, place, std::regex("evaluate calls malloc 1 times, first at (0x[0-9a-f]+)")))
      << out;
  EXPECT_TRUE(run_process({"addr2line", "-fe", module, place[1]}).out.starts_with("evaluate\n"));
}

TEST(ValidateCommand, TellsWhereALibraryAllocatesForAModule) {
  if (test::sanitized) GTEST_SKIP() << "a sanitizer serves malloc";
  const std::string out = output_of(bad_plugin("memory.allocations.cpp"), "memory.allocations");
  EXPECT_TRUE(
      std::regex_search(out, std::regex("evaluate calls operator new [0-9]+ times, first at 0x[0-9a-f]+")))
      << out;
}

TEST(ValidateCommand, TellsTheSystemCallAndItsPlace) {
  if (test::sanitized)
    GTEST_SKIP() << "a sanitizer's function makes the call, without a frame that leads to it";
  const std::string module = bad_plugin("memory.system-calls");
  const std::string out = output_of(module, "memory.system-calls");
  std::smatch place;
  ASSERT_TRUE(std::regex_search(out, place, std::regex("it calls openat at (0x[0-9a-f]+) \\("))) << out;
  EXPECT_TRUE(run_process({"addr2line", "-fe", module, place[1]}).out.starts_with("evaluate\n"));
}

TEST(ValidateCommand, SkipsComparisonsOfABrushThatDrawsOtherwiseEachTime) {
  const nlohmann::json found = report(bad_plugin("repeat.runs.cpp"), "2");
  EXPECT_EQ(failed_checks(found), Names{"repeat.runs"});
  EXPECT_EQ(text_of(found, "evaluate.stride-zero"), "a brush draws otherwise each time, see repeat.runs");
}

TEST(ValidateCommand, TellsOneFailureWhereLargeBatchesHaveNoRoom) {
  const nlohmann::json found = report(bad_plugin("evaluate.batch-sizes.cpp"), "4");
  EXPECT_EQ(failed_checks(found), Names{"evaluate.batch-sizes"});
  EXPECT_EQ(text_of(found, "evaluate.batch-sizes"),
            "org.example.good: crashes with a batch of 4096 nodes; hosts may pass any number");
  EXPECT_EQ(text_of(found, "repeat.split"),
            "a brush crashes with some sizes of batches, see evaluate.batch-sizes");
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
