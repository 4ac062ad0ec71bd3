#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "run_command.h"
#include "sanitizers/sanitized.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// Runs on a sphere that is drawn on with a brush which misbehaves.
class MisbehavingBrushes : public ::testing::Test {
 protected:
  ProcessResult replay(const std::string& brush, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> command = {BURIN_COMMAND, "replay",  stroke_, "--mesh",
                                        mesh_,         "--brush", brush,   "--json"};
    command.insert(command.end(), options.begin(), options.end());
    return run_process(command, {std::string("BURIN_PLUGIN_PATH=") + BURIN_TEST_PLUGINS});
  }

  CommandFolder folder_;
  std::string mesh_ = folder_.write("sphere.obj", obj_text(sphere(4, 0, 1)));
  std::string stroke_ = folder_.write("a.stroke", equator_stroke(-0.6, 0.6, 21, "\"radius\":0.2"));
};

/// The lines of an output less the warnings of the modules that cannot be loaded.
std::vector<std::string> own_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with(std::string("burin: warning: ") + BURIN_TEST_PLUGINS)) lines.push_back(line);
  return lines;
}

TEST_F(MisbehavingBrushes, LeaveTheOtherBrushesAlone) {
  const ProcessResult result = replay("org.burin.groove");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_GT(nlohmann::json::parse(result.out)["events"], 0);
  EXPECT_NE(result.err.find("wrong_major.burin: is made for version 999"), std::string::npos) << result.err;
  EXPECT_EQ(own_lines(result.err), std::vector<std::string>{});
}

TEST_F(MisbehavingBrushes, AreWarnedOfWhenTheirFilesAreCutOff) {
  std::string whole = read_file(std::filesystem::path(BURIN_COMMAND).parent_path() / "brushes/bead.burin");
  // For no processor: no loader takes even the whole file, so that nothing but Burin's own look at it counts.
  constexpr std::size_t processor = 18;
  whole[processor] = whole[processor + 1] = 0;
  std::filesystem::create_directory(folder_.path("plugins"));
  for (const std::size_t bytes : {std::size_t{40}, std::size_t{4096}, whole.size() / 2, whole.size() - 1}) {
    folder_.write("plugins/bad.burin", whole.substr(0, bytes));
    const ProcessResult result =
        run_process({BURIN_COMMAND, "list"}, {"BURIN_PLUGIN_PATH=" + folder_.path("plugins")});
    EXPECT_EQ(result.exit_code, 0) << bytes;
    EXPECT_EQ(result.err, "burin: warning: " + folder_.path("plugins/bad.burin") +
                              ": is cut off: it ends before what its header names\n");
    EXPECT_NE(result.out.find("org.burin.groove"), std::string::npos);
  }
}

TEST_F(MisbehavingBrushes, AreNamedWhenTheyAreAskedFor) {
  const ProcessResult result = replay("org.burin.test.wrong-major");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  const std::vector<std::string> lines = own_lines(result.err);
  ASSERT_EQ(lines.size(), 1u) << result.err;
  EXPECT_EQ(lines[0].find("burin: --brush: no brush 'org.burin.test.wrong-major'; there are: "), 0u);
  EXPECT_NE(lines[0].find("wrong_major.burin: is made for version 999"), std::string::npos);
}

TEST_F(MisbehavingBrushes, AreWarnedOfWhenADistanceIsNone) {
  const ProcessResult result = replay("org.burin.test.flat-solid");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(result.out)["parts"].size(), 1u);
  const std::vector<std::string> lines = own_lines(result.err);
  ASSERT_EQ(lines.size(), 1u) << result.err;
  EXPECT_EQ(lines[0].find("burin: warning: org.burin.test.flat-solid: what it gives as the distance to its "
                          "solid changes by 0.2"),
            0u)
      << lines[0];
}

TEST_F(MisbehavingBrushes, PrintToTheStandardError) {
  const ProcessResult result = replay("org.burin.test.printing");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_GT(nlohmann::json::parse(result.out)["events"], 0);
  std::vector<std::string> lines = own_lines(result.err);
  std::sort(lines.begin(), lines.end());
  EXPECT_EQ(lines, (std::vector<std::string>{"by stdio", "by streams", "by the system"}));
}

TEST_F(MisbehavingBrushes, AreErrorsWhenTheyEndTheProcess) {
  const ProcessResult result = replay("org.burin.test.exiting", {"--save-mesh", folder_.path("out.ply")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(own_lines(result.err),
            std::vector<std::string>{"burin: brush org.burin.test.exiting called exit()"});
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.ply")));
}

TEST_F(MisbehavingBrushes, AreNamedWhenTheyCrash) {
  const ProcessResult result = replay("org.burin.test.crashing", {"--save-mesh", folder_.path("out.ply")});
  EXPECT_NE(result.exit_code, 0);
  if (!test::sanitized) {  // whose own handlers end the process by a code of theirs
    EXPECT_EQ(result.exit_code, -1) << "the signal ends the process, so that it may leave a core";
  }
  EXPECT_EQ(own_lines(result.err)[0], "burin: brush org.burin.test.crashing crashed: segmentation fault");
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.ply")));
}

TEST_F(MisbehavingBrushes, AreErrorsWhenTheyDisplaceAbsurdly) {
  const ProcessResult result = replay("org.burin.test.absurd");
  EXPECT_EQ(result.exit_code, 2);
  const std::vector<std::string> lines = own_lines(result.err);
  ASSERT_EQ(lines.size(), 1u) << result.err;
  EXPECT_EQ(lines[0].find("burin: " + stroke_ +
                          ": stroke 1: org.burin.test.absurd: returned a displacement of 200, "
                          "more than 1000 radii at t = "),
            0u)
      << lines[0];
}

TEST(StandardOutput, TakesResultsThatCannotBeWrittenForErrors) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const ProcessResult result =
      run_process({"sh", "-c", std::string(BURIN_COMMAND) + " list > /dev/full"}, {"BURIN_PLUGIN_PATH="});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: standard output: writing failed\n");
}

}  // namespace
}  // namespace burin::test
