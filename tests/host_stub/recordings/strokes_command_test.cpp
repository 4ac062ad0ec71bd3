#include <burin/base/file.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_stub/picture_file.h"
#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// Two strokes at 100 Hz with a gap, a repeated place, a repeated time and a touch without pressure.
const char* const csv =
    "stroke,x,y,time,pressure\n"
    "1,0,0,0.00,0\n1,1,0,0.01,0.5\n1,1,0,0.02,0.5\n1,2,0,0.02,0.5\n1,3,0,0.12,1\n"
    "2,5,8,7.00,1\n2,6,8,7.01,1\n";

TEST(StrokesCommand, TellsWhatFilesHold) {
  const CommandFolder folder;
  const std::string a = folder.write("a", csv), b = folder.write("b", "x,y,timestamp\n1,2,9\n3,4,9\n");
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
  EXPECT_EQ(json[1]["not_used"], nlohmann::json({"timestamp"}));
  const std::string text = burin_output({"strokes", a, b});
  EXPECT_NE(text.find(a + ": csv, 2 strokes, 7 samples"), text.npos) << text;
  EXPECT_NE(text.find("no time"), text.npos) << text;
  EXPECT_NE(text.find("not used: the columns timestamp\n"), text.npos) << text;
}

/// A page of reMarkable's version 6: a line in a group beside typed text.
std::string line_beside_text() {
  const std::string group = "\x1f\1\x1e", set_by = "\x1f\1\5";
  const auto size = [](const std::string& content) {
    return static_cast<char>(content.size()) + std::string(3, '\0');
  };
  const auto part = [&](const std::string& tag, const std::string& content) {
    return tag + size(content) + content;
  };
  const auto block = [&](char type, const std::string& content) {
    return size(content) + std::string("\0\1\2", 3) + type + content;
  };
  const std::string anchor =
      part("\x7c", set_by + "\x2f\1\x16") + part("\xac\1", set_by + std::string("\x24\0\0\0\0", 5));
  const std::string line =
      part("\x6c", std::string("\3\x14\x0f\0\0\0", 6) +
                       part("\x5c", std::string("\0\0\x80\x3f\0\0\0\x40\0\0\6\0\0\x33", 14)));
  return "reMarkable .lines file, version=6          " + block(2, group + anchor) +
         block(5, group + std::string("\x2f\1\x0a\x3f\1\0\x4f\1\0", 9) + line);
}

TEST(StrokesCommand, TellsThatPlacesBesideTypedTextAreEstimates) {
  const CommandFolder folder;
  const std::string page = folder.write("a.rm", line_beside_text());
  EXPECT_EQ(burin_json({"strokes", page})[0]["y_estimated_strokes"], 1);
  EXPECT_NE(burin_output({"strokes", page})
                .find("px; y of 1 strokes beside typed text is estimated, since the file does not tell the "
                      "heights of "
                      "its lines\n"),
            std::string::npos);
}

TEST(StrokesCommand, RefusesWhatIsNoPenFile) {
  const CommandFolder folder;
  const ProcessResult result = burin({"strokes", folder.write("a", "nothing known\n")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("no pen file that is known"), std::string::npos);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
}

/// A sphere file, and a spiral of two strokes of a pen with an exact repeat in it.
struct Drawing {
  CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(sphere(4, 0, 1)));

  std::string spiral(bool clean) const {
    std::string text = "stroke,x,y,time,pressure\n";
    for (int i = 0; i < 200; ++i) {
      const double angle = 0.1 * i;
      const std::string line = fmt::format("{},{},{},{},{}\n", 1 + i / 100, 5 * angle * std::cos(angle),
                                           5 * angle * std::sin(angle), 0.01 * i, 0.005 * i);
      text += line;
      if (!clean && i == 50) text += line;
    }
    return folder.write("spiral.csv", text);
  }
};

/// The number of pixels of a picture that are blue, and that are yellow.
std::pair<int, int> blue_and_yellow(const std::string& path) {
  const Picture picture = read_png(path);
  std::pair<int, int> count;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto [r, g, b] = pixel(picture, x, y);
      if (b > 150 && r < 90) ++count.first;
      if (r > 200 && g > 150 && b < 110) ++count.second;
    }
  return count;
}

TEST(StrokesCommand, DrawsStrokesInThePlaneColouredByPressure) {
  const Drawing drawing;
  const std::string png = drawing.folder.path("a.png");
  EXPECT_EQ(
      burin_output({"strokes", drawing.spiral(true), "--png", png, "--width", "300", "--height", "200"}),
      png + ": pressure 0.005 blue to 0.995 yellow\n");
  const auto [blue, yellow] = blue_and_yellow(png);
  EXPECT_GT(blue, 30);
  EXPECT_GT(yellow, blue) << "the outer turns are longer";
  const auto by_speed = burin_json({"strokes", drawing.spiral(true), "--png", png, "--colour", "speed"});
  EXPECT_EQ(by_speed["colour"], "speed");
  EXPECT_NEAR(by_speed["range"][0], 50, 1) << "5 units in 0.1 s";
  EXPECT_EQ(burin_output({"strokes", drawing.folder.write("b", "x,y\n0,0\n9,9\n"), "--png", png}),
            png + ": the strokes have no speed\n");
}

TEST(StrokesCommand, DrawsStrokesOnAMesh) {
  const Drawing drawing;
  const std::string png = drawing.folder.path("a.png"), plain = drawing.folder.path("plain.png");
  const std::vector<std::string> view = {"--view",   "0,0,-1", "--width", "200",
                                         "--height", "150",    "--mesh",  drawing.mesh};
  const auto with_view = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), view.begin(), view.end());
    burin_output(arguments);
  };
  with_view({"render", "--png", plain});
  with_view({"strokes", drawing.spiral(true), "--png", png});
  const Picture strokes = read_png(png), ground = read_png(plain);
  int changed = 0;
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) {
      if (pixel(strokes, x, y) == pixel(ground, x, y)) continue;
      ++changed;
      EXPECT_LT(std::hypot(x - 100, y - 75), 75) << "on the sphere";
    }
  EXPECT_GT(changed, 500);
}

TEST(StrokesCommand, WritesACleanFileBitForBit) {
  const Drawing drawing;
  const std::string clean = drawing.spiral(true), out = drawing.folder.path("out.csv");
  EXPECT_EQ(burin_output({"strokes", clean, "--fix", "--out", out}), clean + ": nothing to do\n");
  EXPECT_EQ(read_file(out), read_file(clean));
  const std::string strokes = drawing.folder.write("a.stroke", equator_stroke(0, 1, 30, "\"radius\": 0.20"));
  const std::string copy = drawing.folder.path("copy.stroke");
  burin_output({"strokes", strokes, "--fix", "--out", copy});
  EXPECT_EQ(read_file(copy), read_file(strokes));
}

TEST(StrokesCommand, TellsLineByLineWhatItMends) {
  const Drawing drawing;
  const std::string worn = drawing.spiral(false), out = drawing.folder.path("out.csv");
  EXPECT_EQ(burin_output({"strokes", worn, "--fix", "--out", out}),
            worn + ": stroke 1, sample 52: a duplicate of the one before; left out\n");
  EXPECT_EQ(burin_json({"strokes", out})[0]["samples"], 200);
  const auto json = burin_json({"strokes", worn, "--fix", "--out", out});
  EXPECT_EQ(json["did"].size(), 1u);
}

TEST(StrokesCommand, SplitsJoinsAndResamplesStrokeFilesWithTheirSettings) {
  const Drawing drawing;
  const std::string strokes = drawing.folder.write("a.stroke", equator_stroke(0, 1, 30, "\"radius\": 0.2"));
  const std::string pieces = drawing.folder.path("pieces.stroke"), even = drawing.folder.path("even.stroke");
  burin_output({"strokes", strokes, "--split", "0.005", "--out", pieces});
  EXPECT_EQ(burin_json({"strokes", pieces})[0]["strokes"], 30);
  burin_output({"strokes", pieces, "--join", "0.02", "--resample", "1000", "--out", even});
  const auto facts = burin_json({"strokes", even})[0];
  EXPECT_EQ(facts["kind"], "stroke");
  EXPECT_EQ(facts["strokes"], 1);
  EXPECT_NEAR(facts["time"]["median_interval_s"], 0.001, 1e-9);
  EXPECT_EQ(*read_strokes(even).strokes.at(0).settings.find(&StrokeSettings::radius), 0.2);
}

TEST(StrokesCommand, TellsThatARecordingWasCutOff) {
  const Drawing drawing;
  std::string text = equator_stroke(0, 1, 30, "\"radius\": 0.2");
  text.resize(text.size() - 20);
  const std::string strokes = drawing.folder.write("a.stroke", text);
  const std::string out = drawing.folder.path("out.stroke"), place = strokes + ":32: ";
  const ProcessResult facts = burin({"strokes", strokes, "--json"});
  EXPECT_EQ(facts.exit_code, 0);
  EXPECT_EQ(facts.err, "burin: warning: " + place + "the recording was cut off here\n");
  for (const std::vector<std::string>& edit : {std::vector<std::string>{"--fix"}, {"--resample", "200"}}) {
    std::vector<std::string> arguments = {"strokes", strokes, "--out", out};
    arguments.insert(arguments.end(), edit.begin(), edit.end());
    const std::string told = burin_output(arguments);
    EXPECT_TRUE(
        told.starts_with(strokes + ": line 32: the recording was cut off here; its last stroke ends there\n"))
        << told;
    EXPECT_FALSE(read_strokes(out).cut_off_at);
  }
}

TEST(StrokesCommand, ReadsStrokeFilesAsLongAsReplayDoes) {
  const Drawing drawing;
  std::string text = equator_stroke(0, 1, 30, "\"radius\": 0.2");
  text.append(61'000'000, ' ');
  const std::string strokes = drawing.folder.write("a.stroke", text);
  EXPECT_EQ(burin_json({"strokes", strokes})[0]["samples"], 30);
}

TEST(StrokesCommand, RefusesOptionsThatDoNotGoTogether) {
  const Drawing drawing;
  const std::string spiral = drawing.spiral(true), out = drawing.folder.path("out.csv");
  const std::vector<std::vector<std::string>> wrong = {{"--fix"},
                                                       {"--out", out},
                                                       {"--mesh", drawing.mesh},
                                                       {spiral, "--fix", "--out", out},
                                                       {"--fix", "--out", out, "--png", "a.png"},
                                                       {"--fix", "--out", drawing.folder.path("out.stroke")},
                                                       {"--resample", "0", "--out", out},
                                                       {"--split", "-1", "--out", out}};
  for (std::vector<std::string> arguments : wrong) {
    arguments.insert(arguments.begin(), {"strokes", spiral});
    const ProcessResult result = burin(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments[2];
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace burin::test
