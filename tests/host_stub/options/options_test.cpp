#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host_stub/run_command.h"

namespace burin::test {
namespace {

TEST(Options, NameThemselvesAndWhatTheyTakeInOneLine) {
  const struct {
    std::vector<std::string> arguments;
    std::string line;
  } refused[] = {
      {{"import", "a", "--fit", "none"}, "--fit: must be one of view, mesh, not 'none'"},
      {{"import", "a", "--format", "x\033[0m"},
       "--format: must be one of auto, pen, mypaint, pointer, svc, not 'x\\x1b[0m'"},
      {{"import", "a", "--pressure-from", "speed"}, "--pressure-from: must be width, not 'speed'"},
      {{"import", "a", "--scheme", "x"}, "--scheme: must be one of auto, catmull-clark, loop, not 'x'"},
      {{"import", "a", "--fit"}, "--fit needs a value: view|mesh"},
      {{"import", "a", "--speed"}, "--speed needs a value: NUMBER > 0"},
      {{"import", "a", "--page", "0"}, "--page: must be a whole number from 1 on, not '0'"},
      {{"import", "a", "--layer", "x"}, "--layer: must be a whole number from 1 on, not 'x'"},
      {{"import", "a", "--weld", "-1"}, "--weld: must be a number from 0 on, not '-1'"},
      {{"strokes", "a", "--colour", "red"}, "--colour: must be one of pressure, speed, not 'red'"},
      {{"strokes", "a", "--split", "nan"}, "--split: must be a number from 0 on, not 'nan'"},
      {{"chart", "a", "--order", "3"}, "--order: must be one of 1, 2, not '3'"},
      {{"chart", "a", "--stroke", "0"}, "--stroke: must be a whole number from 1 on, not '0'"},
      {{"snap", "a", "--ends", "x"}, "--ends: must be one of free, fixed, not 'x'"},
      {{"snap", "a", "--feature", "x"},
       "--feature: must be one of ridge, valley, silhouette, suggestive, border, crease, scalar:NAME, not "
       "'x'"},
      {{"replay", "a", "--watch=-1"}, "--watch: must be a whole number from 0 on, not '-1'"}};
  for (const auto& [arguments, line] : refused) {
    const ProcessResult result = burin(arguments);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_EQ(result.err, "burin: " + line + "\n");
  }
  EXPECT_EQ(burin_output({"man-page"}).find("OR {"), std::string::npos) << "CLI11's list of words";
}

TEST(Options, TakeWordsInWhateverCase) {
  const CommandFolder folder;
  const std::string drawing = folder.write("a.csv", "x,y\n1,2\n");
  EXPECT_EQ(burin_output({"import", drawing, "--list", "--format", "PEN", "--fit", "Mesh"}),
            burin_output({"import", drawing, "--list"}));
}

}  // namespace
}  // namespace burin::test
