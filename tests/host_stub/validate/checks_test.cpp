// What the checks find in plugins with a fault each, and that they find nothing in others.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "sanitizers/sanitized.h"
#include "validate_reports.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

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

TEST(ValidateCommand, FindsSoftRangesThatWereForgotten) {
  const nlohmann::json found = expect_one_failure("several.soft-range", "descriptor.param-ranges");
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
    const nlohmann::json found = expect_one_failure(plugin, "host.newer");
    EXPECT_EQ(text_of(found, "host.newer"), "org.example.good: " + text);
  }
}

TEST(ValidateCommand, TriesNoInfiniteValuesOfARangeWithoutAnEnd) {
  const nlohmann::json found = expect_one_failure("several.endless-range", "descriptor.param-ranges");
  EXPECT_EQ(text_of(found, "descriptor.param-ranges"),
            "org.example.good: parameter 'height': its soft range is not finite");
}

TEST(ValidateCommand, LooksAfterAStrokeWhatAModuleLeaves) {
  const nlohmann::json file = expect_one_failure("several.keeps-file", "module.unloads");
  EXPECT_EQ(text_of(file, "module.unloads"), "leaves a file open after its last deinit");
  const nlohmann::json loaded = expect_one_failure("several.stays-loaded", "module.unloads");
  EXPECT_TRUE(text_of(loaded, "module.unloads").starts_with("stays in memory after it was unloaded"));
  for (int time = 0; time < 20; ++time)
    EXPECT_EQ(burin({"validate", bad_plugin("several.joins-thread"), "--only", "module.unloads"}).exit_code,
              0);
}

TEST(ValidateCommand, MeasuresTheRimSlopeFromTheRimToTheMiddle) {
  expect_one_failure("several.rim-inside", "shape.rim");
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
  expect_one_failure("several.calls-exit", "life.begin-default");
  EXPECT_TRUE(output_of(bad_plugin("several.calls-exit"), "life.begin-default")
                  .starts_with("CRASH   life.begin-default: ended the process with exit code 0\n"));
}

TEST(ValidateCommand, TellsOfAFailureWithoutAText) {
  const nlohmann::json found = expect_one_failure("several.no-text", "host.text-capacity");
  EXPECT_EQ(text_of(found, "host.text-capacity"), "create fails without a text");
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

}  // namespace
}  // namespace burin::test
