// Checks that replays give the same bits on processors with different estimate and fused instructions.
#include "support/processors.h"
#include "support/point_shapes.h"

#include <burin/base/file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "run_command.h"

namespace burin {
namespace {

using Words = std::vector<std::string>;

/// The radius of the ball that samples/suites/icosahedron.obj becomes.
constexpr double ball_radius = 0.704;

/// "begin" and the samples of a stroke across the front of the ball, begun at a height above its equator.
/// Pressure and tilt change along it; it bends sharply half way.
std::string wavy_stroke(const std::string& settings, double height) {
  std::string text = fmt::format(
      "{{\"begin\":{{\"radius\":0.3,{}}},"
      "\"fields\":[\"time\",\"x\",\"y\",\"z\",\"pressure\",\"tilt_x\",\"tilt_y\"]}}\n",
      settings);
  for (int i = 0; i < 10; ++i) {
    const double u = i / 9.0, x = 2 * u - 1, y = height + (i < 5 ? 0.9 * u : 0.9 * (1 - u));
    const double scale = ball_radius / std::sqrt(x * x + y * y + 0.4);
    text += fmt::format("[{},{},{},{},{},{},{}]\n", 0.013 * i, x * scale, y * scale, std::sqrt(0.4) * scale,
                        0.3 + 0.6 * u * u, 0.7 - u, 0.2 + 0.5 * u);
  }
  return text + "{\"end\":true}\n";
}

constexpr const char* object_header = "{\"burin_stroke\":1,\"space\":\"object\"}\n";

/// Parameters without which a brush has nothing to draw.
std::string params_of(const std::string& brush) {
  const std::pair<const char*, const char*> stamps[] = {{"org.burin.scales", "stamps/scales.exr"},
                                                        {"org.burin.tread", "stamps/tread.exr"},
                                                        {"org.burin.vdm-trail", "stamps/thorn.exr"},
                                                        {"org.burin.vdb-trail", "solids/rail.vdb"}};
  for (const auto& [id, stamp] : stamps)
    if (brush == id) return fmt::format("\"stamp\":\"{}/{}\"", BURIN_SAMPLES, stamp);
  return brush == "org.burin.patterned-line" ? "\"figure\":\"waves\"" : "";
}

/// A stroke with each of the stock brushes; what varies radius and strength is another source each time.
std::string strokes_of_all_brushes() {
  const char* const sources[] = {"pressure", "tilt", "tilt_direction", "direction", "speed", "random"};
  std::string text = object_header;
  int count = 0;
  const nlohmann::json known = test::burin_json({"list"});
  for (const auto& brush : known.at("brushes")) {
    const auto id = brush["id"].get<std::string>();
    const std::string settings = fmt::format(
        "\"brush\":\"{}\",\"params\":{{{}}},\"dynamics\":["
        "{{\"target\":\"radius\",\"source\":\"{}\",\"curve\":[-3,0.6,3,1]}},"
        "{{\"target\":\"strength\",\"source\":\"{}\",\"curve\":[-3,0.2,3,1]}}]",
        id, params_of(id), sources[count % 6], sources[(count + 1) % 6]);
    text += wavy_stroke(settings, -0.6 + 0.06 * (count % 10));
    ++count;
  }
  EXPECT_EQ(count, 26);
  return text;
}

/// A stroke over the middle of the picture, seen with a camera that no axis lies along.
std::string screen_stroke() {
  std::string text =
      "{\"burin_stroke\":1,\"space\":\"screen\",\"camera\":{"
      "\"view\":[0.8,-0.36,0.48,0,0,0.8,0.6,0,-0.6,-0.48,0.64,0,0.1,-0.07,-5.6,1],"
      "\"projection\":[2.799038106,0,0,0,0,3.732050808,0,0,0,0,-1.687368145,-1,0,0,-6.007326316,0],"
      "\"viewport\":[640,480]}}\n"
      "{\"begin\":{\"brush\":\"org.burin.groove\",\"radius\":0.3},\"fields\":[\"time\",\"x\",\"y\"]}\n";
  for (int i = 0; i < 8; ++i)
    text += fmt::format("[{},{},{}]\n", 0.013 * i, 270.3 + 17.7 * i, 225.1 + 9 * i - i * i);
  return text + "{\"end\":true}\n";
}

struct Result {
  std::string hash, mesh;
};

/// The result of a replay on the ball of 5,120 triangles.
Result replayed(const test::Processor& processor, const test::CommandFolder& folder, Words more) {
  const std::string mesh = folder.path("result.ply");
  Words words{BURIN_COMMAND, "replay", "--mesh", BURIN_SAMPLES "/suites/icosahedron.obj", "--subdivide", "4",
              "--save-mesh", mesh,     "--json"};
  words.insert(words.end(), more.begin(), more.end());
  Words environment = processor.environment;
  environment.push_back("BURIN_PLUGIN_PATH=");
  const test::ProcessResult run = test::run_process(processor.command(words), environment);
  EXPECT_EQ(run.exit_code, 0) << processor.name << ": " << run.err;
  if (run.exit_code != 0) return {};
  const auto summary = nlohmann::json::parse(run.out);
  EXPECT_EQ(summary["events_off_surface"], 0);
  return {summary["result_hash"], read_file(mesh)};
}

void expect_same_everywhere(const test::CommandFolder& folder, const Words& arguments) {
  const auto processors = test::processors();
  const Result here = replayed(processors.front(), folder, arguments);
  EXPECT_EQ(here.hash.size(), 16u);
  for (const test::Processor& processor : processors) {
    const Result there = replayed(processor, folder, arguments);
    EXPECT_EQ(there.hash, here.hash) << processor.name;
    EXPECT_TRUE(there.mesh == here.mesh) << processor.name << ": positions, colours or masks differ";
  }
}

TEST(Processors, GiveAllBrushesTheSameBits) {
  const test::CommandFolder folder;
  // Coarse voxels, since other processors are slow here.
  expect_same_everywhere(folder, {folder.write("all.stroke", strokes_of_all_brushes()), "--voxel", "0.05"});
}

TEST(Processors, GiveSymmetricStabilisedAndScreenStrokesTheSameBits) {
  const test::CommandFolder folder;
  const std::string two = object_header + wavy_stroke("\"brush\":\"org.burin.rope\"", -0.4) +
                          wavy_stroke("\"brush\":\"org.burin.bark\",\"closed\":true", 0);
  const Words files{folder.write("two.stroke", two), folder.write("screen.stroke", screen_stroke())};
  Words symmetric = files, dabs = files;
  for (const char* word : {"--radial", "3", "--mirror", "z", "--stabilise", "string:0.1", "--join", "miter"})
    symmetric.emplace_back(word);
  for (const char* word : {"--dabs", "1", "--stabilise", "exponential:0.02", "--pressure-width", "0.5"})
    dabs.emplace_back(word);
  expect_same_everywhere(folder, symmetric);
  expect_same_everywhere(folder, dabs);
}

/// The table of coordinates of a stroke that is picked on points.
TEST(Processors, GiveChartsOfPointSetsTheSameBits) {
  const test::CommandFolder folder;
  const std::string points = folder.write("points.ply", test::ply_text(test::sphere_points(4, 9))),
                    stroke = folder.write("screen.stroke", screen_stroke()), table = folder.path("a.csv");
  std::string here;
  for (const test::Processor& processor : test::processors()) {
    const test::ProcessResult run = test::run_process(
        processor.command({BURIN_COMMAND, "chart", stroke, "--mesh", points, "--csv", table}),
        processor.environment);
    ASSERT_EQ(run.exit_code, 0) << processor.name << ": " << run.err;
    if (here.empty()) here = read_file(table);
    EXPECT_TRUE(read_file(table) == here) << processor.name;
  }
  EXPECT_GT(here.size(), 10000u);
}

}  // namespace
}  // namespace burin
