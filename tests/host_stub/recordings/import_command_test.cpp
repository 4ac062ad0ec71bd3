#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// Two strokes, a cross of 100 x 50 pixels, with the pen down for 22 events.
std::string mypaint_events() {
  std::string text;
  double time = 0;
  const auto event = [&](double x, double y, double pressure) {
    text += fmt::format("{} {} {} {}\n", time += 0.008, x, y, pressure);
  };
  event(10, 35, 0);
  for (int i = 0; i <= 10; ++i) event(10 + 10 * i, 35, 0.5);
  event(60, 10, 0);
  for (int i = 0; i <= 10; ++i) event(60, 10 + 5 * i, 0.25);
  event(60, 60, 0);
  return text;
}

TEST(ImportCommand, GivesStrokesInFrontOfTheMesh) {
  const CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(sphere(4, 0, 1)));
  const std::string events = folder.write("events.dat", mypaint_events());
  const auto json =
      burin_json({"import", events, "--mesh", mesh, "--view", "0,0,-1", "--width", "400", "--height", "300",
                  "--out", folder.path("a.stroke"), "--brush", "org.burin.groove", "--radius", "0.05"});
  EXPECT_EQ(json["strokes"], 2);
  const Recording recording = read_strokes(folder.path("a.stroke"));
  EXPECT_EQ(recording.space, StrokeSpace::screen);
  ASSERT_TRUE(recording.camera);
  EXPECT_EQ(recording.camera->width, 400);
  EXPECT_EQ(recording.camera->height, 300);
  ASSERT_EQ(recording.strokes.size(), 2u);
  std::size_t samples = 0;
  for (const RecordedStroke& stroke : recording.strokes) {
    EXPECT_EQ(stroke.settings.complete().brush, "org.burin.groove");
    EXPECT_EQ(stroke.settings.complete().radius, 0.05);
    EXPECT_TRUE(stroke.fields.pressure);
    samples += stroke.samples.size();
  }
  EXPECT_EQ(json["samples"], samples);
  EXPECT_EQ(json["events"], 25);
  EXPECT_EQ(json["events_lifted"], 3);
  EXPECT_EQ(json["times_raised"], 0);
  EXPECT_EQ(json["pressures_dropped"], 0);
  EXPECT_NEAR(recording.strokes[0].samples[0].position.x(), 40, 1e-3)
      << "a margin of a tenth of the viewport";
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.stroke.partial")));
  const auto replayed = burin_json({"replay", folder.path("a.stroke"), "--mesh", mesh});
  EXPECT_GT(replayed["events"], 10);
}

TEST(ImportCommand, LeavesSettingsOpenUnlessGiven) {
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  const std::string events = folder.write("events.json", mypaint_events());
  burin_output({"import", events, "--format", "mypaint", "--mesh", mesh, "--out", folder.path("a.stroke")});
  const Recording recording = read_strokes(folder.path("a.stroke"));
  ASSERT_EQ(recording.strokes.size(), 2u);
  EXPECT_FALSE(recording.strokes[0].settings.find(&StrokeSettings::brush));
  EXPECT_FALSE(recording.strokes[0].settings.find(&StrokeSettings::radius));
}

TEST(ImportCommand, TellsWhatItLeavesOutAndChanges) {
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  const std::string events = folder.write("a.json", R"({"x": [0,1,2,3], "y": [0,0,1,1], "time": [0,8,6,9],
      "buttons": [1,1,1,0], "pressure": [0,0,0,0]})");
  const std::string out = folder.path("a.stroke");
  const ProcessResult result = burin({"import", events, "--mesh", mesh, "--out", out});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, out + ": 1 strokes, 3 samples of 4 events; 1 left out, the pen lifted\n");
  EXPECT_EQ(result.err,
            "burin: warning: times that fell within a stroke, raised to the one before: 1\n"
            "burin: warning: strokes whose pressure is 0 although the pen touches the tablet, taken as "
            "without: 1\n");
}

TEST(ImportCommand, ReadsPointerEventsByTheExtension) {
  BURIN_SHARED_DATA_OR_SKIP(events, "strokes/bdalab_html5_pointer_signal.json");
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.obj", cube_obj());
  const auto json = burin_json({"import", events.string(), "--mesh", mesh, "--out", folder.path("a.stroke")});
  EXPECT_EQ(json["strokes"], 1);
  EXPECT_TRUE(read_strokes(folder.path("a.stroke")).strokes[0].fields.tilt);
}

TEST(ImportCommand, GivesStrokesOfThreeRecordersThatReplayWithDynamics) {
  BURIN_SHARED_DATA_OR_SKIP(spot, "meshes/spot_control_mesh.obj");
  for (const char* name : {"painting30sec.dat", "bdalab_html5_pointer_signal.json", "bdalab_signal.svc"}) {
    BURIN_SHARED_DATA_OR_SKIP(recording, std::string("strokes/") + name);
    const CommandFolder folder;
    const std::string strokes = folder.path("a.stroke");
    burin_output({"import", recording.string(), "--mesh", spot.string(), "--view", "-1,0,0", "--brush",
                  "org.burin.groove", "--radius", "0.03", "--out", strokes});
    std::vector<std::string> replay = {"replay",      strokes, "--mesh",   spot.string(),
                                       "--subdivide", "3",     "--refine", "off"};
    const auto plain = burin_json(replay);
    const auto dynamics = {"radius=pressure:0,0.3,1,1", "strength=pressure:0,0,0.4,1",
                           "depth=speed:0,1,30,0.5"};
    for (const char* dynamic : dynamics) replay.insert(replay.end(), {"--dynamic", dynamic});
    const auto driven = burin_json(replay);
    EXPECT_GT(driven["events"], 50) << name;
    EXPECT_NE(driven["result_hash"], plain["result_hash"]) << name;
    replay.insert(replay.end(), {"--show-every", "0"});
    EXPECT_EQ(burin_json(replay)["result_hash"], driven["result_hash"]) << name;
  }
}

TEST(ImportCommand, GivesAPaintingThatReplays) {
  BURIN_SHARED_DATA_OR_SKIP(painting, "strokes/painting30sec.dat");
  BURIN_SHARED_DATA_OR_SKIP(spot, "meshes/spot_control_mesh.obj");
  const CommandFolder folder;
  const std::string strokes = folder.path("painting.stroke");
  burin_output({"import", painting.string(), "--mesh", spot.string(), "--view", "-1,0,0", "--brush",
                "org.burin.groove", "--radius", "0.03", "--out", strokes});
  const auto json =
      burin_json({"replay", strokes, "--mesh", spot.string(), "--subdivide", "4", "--refine", "off"});
  EXPECT_GT(json["events"], 1000);
  EXPECT_EQ(json["strokes"], read_strokes(strokes).strokes.size());
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
}

TEST(ImportCommand, ListsPagesLayersAndStrokes) {
  const CommandFolder folder;
  const std::string drawing = folder.write(
      "drawing",
      "<xournal><page><layer><stroke tool='pen' width='1'>1 2 3 4 5 6</stroke></layer></page><page><layer/>"
      "<layer><stroke width='2 1 1'>1 2 3 4 4 4</stroke></layer></page></xournal>");
  EXPECT_EQ(burin_output({"import", drawing, "--list"}),
            "page 1\n  layer 1\n    stroke 1: 3 samples, width\n"
            "page 2\n  layer 2\n    stroke 2: 3 samples, width\n");
  const auto list = burin_json({"import", drawing, "--list"});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1]["page"], 2);
  EXPECT_EQ(list[1]["layer"], 2);
  EXPECT_EQ(list[1]["seconds"], nullptr);
  EXPECT_EQ(list[1]["fields"], nlohmann::json({"width"}));
  EXPECT_EQ(burin_output({"import", folder.write("events.dat", mypaint_events()), "--list"}),
            "page 1\n  layer 1\n    stroke 1: 11 samples, 0.080 s, pressure\n"
            "    stroke 2: 11 samples, 0.080 s, pressure\n");
  for (const auto& missing : {std::vector<std::string>{"--mesh", folder.write("cube.obj", cube_obj())},
                              {"--out", folder.path("a.stroke")}}) {
    const ProcessResult result = burin({"import", drawing, missing[0], missing[1]});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("is required"), std::string::npos) << result.err;
  }
}

TEST(ImportCommand, FitsStrokesOnTheMeshWhereAsked) {
  const CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(sphere(4, 0, 1)));
  const std::string box = folder.write("box", "x,y\n0,0\n9,0\n9,9\n0,9\n");
  const auto lost = [&](const std::vector<std::string>& fit) {
    std::vector<std::string> arguments = {
        "import",           box,        "--mesh", mesh, "--out", folder.path("a.stroke"), "--brush",
        "org.burin.groove", "--radius", "0.05"};
    arguments.insert(arguments.end(), fit.begin(), fit.end());
    burin_output(arguments);
    const ProcessResult drawn = burin({"replay", folder.path("a.stroke"), "--mesh", mesh, "--json"});
    return nlohmann::json::parse(drawn.out)["events_off_surface"].get<int>();
  };
  EXPECT_EQ(lost({}), 4) << "the corners of the view";
  EXPECT_EQ(lost({"--fit", "mesh"}), 0);
}

}  // namespace
}  // namespace burin::test
