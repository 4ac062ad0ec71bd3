#include <gtest/gtest.h>

#include <algorithm>

#include "run_command.h"

namespace burin::test {
namespace {

/// Two strokes at 100 Hz with a gap, a repeated place, a repeated time and a touch without pressure.
const char* const csv =
    "stroke,x,y,time,pressure\n"
    "1,0,0,0.00,0\n1,1,0,0.01,0.5\n1,1,0,0.02,0.5\n1,2,0,0.02,0.5\n1,3,0,0.12,1\n"
    "2,5,8,7.00,1\n2,6,8,7.01,1\n";

TEST(StrokesCommand, TellsWhatFilesHold) {
  const CommandFolder folder;
  const std::string a = folder.write("a", csv), b = folder.write("b", "x,y\n1,2\n3,4\n");
  const auto json = burin_json({"strokes", a, b});
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["file"], a);
  EXPECT_EQ(json[0]["kind"], "csv");
  EXPECT_EQ(json[0]["strokes"], 2);
  EXPECT_EQ(json[0]["samples"], 7);
  EXPECT_EQ(json[0]["samples_per_stroke"], nlohmann::json({2, 2, 5}));
  EXPECT_EQ(json[0]["duplicates"], 1);
  EXPECT_EQ(json[0]["contact_without_pressure"], 1);
  EXPECT_EQ(json[0]["pressure"], nlohmann::json({0, 1}));
  EXPECT_EQ(json[0]["x"], nlohmann::json({0, 6}));
  EXPECT_EQ(json[0]["time"]["gaps"], 1);
  EXPECT_EQ(json[0]["time"]["equal_stamps"], 1);
  EXPECT_EQ(json[0]["time"]["falling_times"], 0);
  EXPECT_NEAR(json[0]["time"]["median_interval_s"], 0.01, 1e-9);
  EXPECT_NEAR(json[0]["time"]["ink_seconds"], 0.13, 1e-9);
  EXPECT_NEAR(json[0]["time"]["rate_hz"], 5 / 0.13, 1e-6);
  EXPECT_EQ(json[0]["tilt_x_rad"], nullptr);
  EXPECT_EQ(json[1]["time"], nullptr);
  EXPECT_EQ(json[1]["pressure"], nullptr);
  EXPECT_EQ(json[1]["samples"], 2);
  const std::string text = burin_output({"strokes", a, b});
  EXPECT_NE(text.find(a + ": csv, 2 strokes, 7 samples"), text.npos) << text;
  EXPECT_NE(text.find("no time"), text.npos) << text;
}

TEST(StrokesCommand, RefusesWhatIsNoPenFile) {
  const CommandFolder folder;
  const ProcessResult result = burin({"strokes", folder.write("a", "nothing known\n")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("no pen file that is known"), std::string::npos);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
}

TEST(ImportCommand, TakesOnlyThePageAndLayerAskedFor) {
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  const std::string drawing = folder.write(
      "drawing",
      "<xournal><page><layer><stroke width='1'>1 2 3 4 5 6</stroke></layer><layer><stroke width='1'>1 2 "
      "3 4</stroke></layer></page></xournal>");
  EXPECT_EQ(burin_json({"strokes", drawing})[0]["layers"], 2);
  const auto imported = [&](const std::string& layer) {
    return burin({"import", drawing, "--mesh", mesh, "--layer", layer, "--out", folder.path("a.stroke")});
  };
  EXPECT_EQ(imported("2").out,
            folder.path("a.stroke") + ": 1 strokes, 2 samples of 2 events; 0 left out, the pen lifted\n");
  const ProcessResult none = imported("3");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("holds no stroke"), std::string::npos);
  const std::string events = folder.write("events", "0 1 2 0.5\n0.1 3 4 0.5\n");
  const ProcessResult refused =
      burin({"import", events, "--mesh", mesh, "--page", "1", "--out", folder.path("b.stroke")});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("neither pages nor layers"), std::string::npos);
}

}  // namespace
}  // namespace burin::test
