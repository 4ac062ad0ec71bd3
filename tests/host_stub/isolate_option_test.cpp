// The option --isolate, with brushes that misbehave.
#include <gtest/gtest.h>

#include "run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

class IsolateOption : public ::testing::Test {
 protected:
  std::vector<std::string> command(const std::string& brush, std::vector<std::string> options = {}) const {
    std::vector<std::string> words = {BURIN_COMMAND, "replay",  stroke_, "--mesh",
                                      mesh_,         "--brush", brush,   "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
  ProcessResult replay(const std::string& brush, const std::vector<std::string>& options = {}) const {
    return run_process(command(brush, options), {std::string("BURIN_PLUGIN_PATH=") + BURIN_TEST_PLUGINS});
  }

  CommandFolder folder_;
  std::string mesh_ = folder_.write("sphere.obj", obj_text(sphere(4, 0, 1)));
  std::string stroke_ = folder_.write("a.stroke", equator_stroke(-0.6, 0.6, 21, "\"radius\":0.2"));
};

TEST_F(IsolateOption, ChangesNoBit) {
  const ProcessResult here = replay("org.burin.groove"), there = replay("org.burin.groove", {"--isolate"});
  ASSERT_EQ(there.exit_code, 0) << there.err;
  EXPECT_EQ(nlohmann::json::parse(there.out)["result_hash"], nlohmann::json::parse(here.out)["result_hash"]);
  EXPECT_EQ(there.err, here.err);
  EXPECT_EQ(burin_output({"list", "--isolate"}), burin_output({"list"}));
}

TEST_F(IsolateOption, MakesAnErrorOfACrash) {
  const ProcessResult result =
      replay("org.burin.test.crashing", {"--isolate", "--save-mesh", folder_.path("out.ply")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  const std::string line =
      "burin: " + stroke_ +
      ": stroke 1: org.burin.test.crashing: crashed: segmentation fault at address 0x0 in ";
  const std::size_t place = result.err.find(line);
  ASSERT_NE(place, std::string::npos) << result.err;
  EXPECT_NE(result.err.find("CrashingBrush>::evaluate, crashing_brush.burin+0x", place), std::string::npos)
      << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.ply")));
}

TEST_F(IsolateOption, LeavesWhatABrushPrintsToTheStandardError) {
  const ProcessResult result = replay("org.burin.test.printing", {"--isolate"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_GT(nlohmann::json::parse(result.out)["events"], 0);
  for (const char* line : {"by stdio\n", "by streams\n", "by the system\n"})
    EXPECT_NE(result.err.find(line), std::string::npos) << result.err;
}

TEST_F(IsolateOption, LeavesNoProcessWhenTheCommandIsKilled) {
  std::string words;
  for (const std::string& word :
       command("org.burin.test.failing", {"--isolate", "--param", "text=begin:hang"}))
    words += "'" + word + "' ";
  // The process of the brush hangs where it would see that the command is gone. It is gone itself in a
  // moment, or somebody's zombie.
  const ProcessResult result =
      run_process({"sh", "-c",
                   words + "& host=$!; sleep 1; brush=$(cat /proc/$host/task/*/children); kill -9 $host; "
                           "test -n \"$brush\" || exit 3; "
                           "for i in 1 2 3 4 5 6 7 8 9; do grep -q 'State:.[^Z]' /proc/${brush% }/status "
                           "2>/dev/null || exit 0; "
                           "sleep 0.1; done; exit 4"},
                  {std::string("BURIN_PLUGIN_PATH=") + BURIN_FAILING_BRUSHES});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace burin::test
