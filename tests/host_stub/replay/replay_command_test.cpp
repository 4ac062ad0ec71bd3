#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "host_stub/picture_file.h"
#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

using nlohmann::json;

constexpr const char* groove = "\"brush\":\"org.burin.groove\",\"radius\":0.2";

/// A unit sphere in random vertex order and a groove along its equator.
struct Engraving {
  CommandFolder folder;
  TriangleMesh mesh = shuffled(sphere(5, 0.2, 3), 4);
  std::string mesh_path = folder.write("sphere.obj", obj_text(mesh));
  std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, groove));

  std::vector<std::string> command(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"replay", stroke, "--mesh", mesh_path};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }

  /// The surface that --save-mesh writes.
  std::vector<Vec3f> engraved(std::vector<std::string> options) const {
    options.insert(options.end(), {"--save-mesh", folder.path("out.ply")});
    burin_output(command(options));
    return read_mesh(folder.path("out.ply")).positions;
  }

  double depth(const std::vector<std::string>& options) const {
    double deepest = 0;
    for (const Vec3f& p : engraved(options)) deepest = std::max(deepest, 1 - static_cast<double>(p.norm()));
    return deepest;
  }

  std::size_t moved(const std::vector<std::string>& options) const {
    const std::vector<Vec3f> positions = engraved(options);
    std::size_t count = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) count += positions[i] != mesh.positions[i] ? 1 : 0;
    return count;
  }
};

/// A triangle by its smallest vertex first.
Triangle turned(Triangle triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

TEST(ReplayCommand, TellsOfClocksThatStand) {
  Engraving engraving;
  engraving.stroke = engraving.folder.write(
      "b.stroke", std::string(R"({"burin_stroke":1,"space":"object"})") + "\n" + R"({"begin":{)" + groove +
                      R"(},"fields":["time","x","y","z"]})" + "\n[3,0,0,1]\n[3,0.1,0,1]\n{\"end\":true}\n");
  const ProcessResult result = burin(engraving.command({"--json"}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err,
            "burin: warning: strokes whose time stamps are all equal, taken as without times: 1\n");
}

TEST(ReplayCommand, BlendsOverlapsAsTold) {
  Engraving engraving;
  engraving.stroke = engraving.folder.write(
      "b.stroke",
      equator_stroke(0, 12, 601, std::string(groove) + ",\"params\":{\"depth\":0.1,\"taper\":0}"));
  const double once = engraving.depth({});
  EXPECT_NEAR(once, 0.02, 1e-3);
  for (const char* same : {"latest", "max", "min", "average"})
    EXPECT_NEAR(engraving.depth({"--overlap", same}), once, 1e-4) << same;
  EXPECT_NEAR(engraving.depth({"--overlap", "add"}), 2 * once, 1e-3);
  EXPECT_NE(burin(engraving.command({"--overlap", "sum"})).exit_code, 0);
}

TEST(ReplayCommand, ClosesStrokesAsRecordedOrTold) {
  Engraving engraving;
  const std::string closed = std::string(groove) + ",\"closed\":true";
  engraving.stroke = engraving.folder.write("b.stroke", equator_stroke(0, 6.2, 120, closed));
  const auto hash = [&](const std::vector<std::string>& options) {
    return burin_json(engraving.command(options))["result_hash"];
  };
  EXPECT_EQ(hash({}), hash({"--closed", "yes"}));
  EXPECT_EQ(hash({}), hash({"--closed", "auto"}));
  EXPECT_NE(hash({}), hash({"--closed", "no"}));
  engraving.stroke = engraving.folder.write("c.stroke", equator_stroke(0, 6.2, 2, closed));
  const ProcessResult result = burin(engraving.command({}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("too short: 1"), std::string::npos) << result.err;
}

TEST(ReplayCommand, TakesTheWidthFromThePressure) {
  Engraving engraving;
  std::string text = "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{" + std::string(groove) +
                     "},\"fields\":[\"x\",\"y\",\"z\",\"pressure\"]}\n";
  for (int i = 0; i <= 60; ++i)
    text += fmt::format("[{},0,{},0.5]\n", std::sin(0.02 * i), std::cos(0.02 * i));
  engraving.stroke = engraving.folder.write("b.stroke", text + "{\"end\":true}\n");
  const double full = engraving.depth({}), narrow = engraving.depth({"--pressure-width", "0.8"});
  EXPECT_NEAR(narrow, 0.6 * full, 0.01 * full) << "half the pressure, 0.6 of the width";
  EXPECT_LT(engraving.moved({"--pressure-width", "0.8"}), 0.75 * static_cast<double>(engraving.moved({})));
  EXPECT_NE(burin(engraving.command({"--pressure-width", "1.2"})).exit_code, 0);
}

TEST(ReplayCommand, LetsThePenDriveTheStroke) {
  Engraving engraving;
  const double full = engraving.depth({});
  EXPECT_NEAR(engraving.depth({"--dynamic", "strength=t:0,0.5"}), full / 2, 1e-3);
  EXPECT_NEAR(engraving.depth({"--dynamic", "strength=t:0,0.5", "--dynamic", "depth=t:0,2"}), full, 1e-3);
  EXPECT_NEAR(engraving.depth({"--dynamic", "strength=pressure:0,0.5"}), full, 1e-9)
      << "there is no pressure";
  const std::string half = R"(,"dynamics":[{"target":"strength","source":"t","curve":[0,0.5]}])";
  engraving.stroke =
      engraving.folder.write("b.stroke", equator_stroke(-0.6, 0.6, 61, std::string(groove) + half));
  EXPECT_NEAR(engraving.depth({}), full / 2, 1e-3);
  EXPECT_NEAR(engraving.depth({"--dynamic", "strength=time:0,0.25"}), full / 4, 1e-3) << "instead";
  EXPECT_NEAR(engraving.depth({"--dynamic", "depth=time:0,2"}), full, 1e-3) << "besides";
}

TEST(ReplayCommand, CalmsTheHand) {
  const Engraving engraving;
  const auto plain = burin_json(engraving.command({}));
  const auto string = burin_json(engraving.command({"--stabilise", "string:0.3"}));
  const auto lagging = burin_json(engraving.command({"--stabilise", "exponential:0.1"}));
  EXPECT_NE(string["result_hash"], plain["result_hash"]);
  EXPECT_NE(lagging["result_hash"], plain["result_hash"]);
  EXPECT_EQ(string["events"], plain["events"].get<int>() + 1) << "the stroke ends where the pen did";
  const std::string help = burin_output({"replay", "--help"});
  for (const char* option : {"--dynamic TARGET=SOURCE:X0,Y0,X1,Y1,...", "--stabilise KIND:AMOUNT"})
    EXPECT_NE(help.find(option), std::string::npos) << help;
}

TEST(ReplayCommand, DrawsAPictureOfTheResult) {
  const Engraving engraving;
  const std::string png = engraving.folder.path("a.png"), flat_png = engraving.folder.path("b.png");
  const std::vector<std::string> view = {"--width", "160", "--height", "100"};
  const auto picture = [&](const std::string& path, const std::vector<std::string>& options) {
    std::vector<std::string> all = {"--png", path};
    all.insert(all.end(), view.begin(), view.end());
    all.insert(all.end(), options.begin(), options.end());
    burin_output(engraving.command(all));
    return read_png(path);
  };
  const Picture grooved = picture(png, {}), flat = picture(flat_png, {"--strength", "0"});
  EXPECT_EQ(grooved.width, 160);
  EXPECT_EQ(grooved.height, 100);
  int different = 0;
  for (int column = 0; column < 160; ++column)
    different += pixel(grooved, column, 50) != pixel(flat, column, 50) ? 1 : 0;
  EXPECT_GT(different, 60) << "the stroke fills the picture";
  EXPECT_NE(picture(png, {"--view", "1,0,0"}).rgb, grooved.rgb);
  EXPECT_NE(burin(engraving.command({"--png", engraving.folder.path("none/a.png")})).exit_code, 0);
}

TEST(ReplayCommand, TellsWhatItMeasured) {
  const Engraving engraving;
  const json result = burin_json(engraving.command({}));
  EXPECT_EQ(result["mesh"]["vertices"], engraving.mesh.positions.size());
  EXPECT_EQ(result["mesh"]["defects"], "");
  EXPECT_EQ(result["files"], json({engraving.stroke}));
  EXPECT_EQ(result["strokes"], 1);
  EXPECT_EQ(result["pieces"], 1);
  EXPECT_EQ(result["events"], 61);
  EXPECT_EQ(result["events_off_surface"], 0);
  const json latency = result["latency_ms"];
  EXPECT_GT(latency["p50"], 0);
  EXPECT_LE(latency["p50"], latency["p95"]);
  EXPECT_LE(latency["p95"], latency["p99"]);
  EXPECT_LE(latency["p99"], latency["max"]);
  EXPECT_GT(result["vertices_per_second"], 1000);
  EXPECT_GT(result["peak_memory_bytes"], 4e6);
  EXPECT_NEAR(result["peak_memory_bytes_per_vertex"].get<double>() *
                  static_cast<double>(engraving.mesh.positions.size()),
              result["peak_memory_bytes"].get<double>(), 1e3);
  EXPECT_GT(result["seconds_to_first_event"], 0.005);
  EXPECT_LT(result["seconds_to_first_event"], 60);
  EXPECT_EQ(result["result_hash"].get<std::string>().size(), 16u);
}

TEST(ReplayCommand, SaysTheSameAsText) {
  const Engraving engraving;
  const std::string text = burin_output(engraving.command({}));
  const json result = burin_json(engraving.command({}));
  for (const std::string& word :
       {std::string("p50"), std::string("p95"), std::string("p99"), std::string("max"),
        std::string("61 events"), result["result_hash"].get<std::string>()}) {
    EXPECT_NE(text.find(word), std::string::npos) << word << " in\n" << text;
  }
}

TEST(ReplayCommand, SavesTheMeshInTheOrderOfItsFile) {
  const Engraving engraving;
  const std::vector<Vec3f> after = engraving.engraved({});
  ASSERT_EQ(after.size(), engraving.mesh.positions.size());
  std::size_t deep = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vec3f& before = engraving.mesh.positions[i];
    EXPECT_GT(after[i].normalized().dot(before.normalized()), 0.9999f);
    if (std::asin(std::abs(before.y())) > 0.21) {
      EXPECT_EQ(after[i], before);
    }
    deep += after[i].norm() < 0.98f ? 1 : 0;
  }
  EXPECT_GT(deep, 50u);
  const PolygonMesh saved = read_mesh(engraving.folder.path("out.ply"));
  std::set<Triangle> triangles, expected;
  for (std::size_t i = 0; i + 2 < saved.face_vertices.size(); i += 3) {
    triangles.insert(
        turned({saved.face_vertices[i], saved.face_vertices[i + 1], saved.face_vertices[i + 2]}));
  }
  for (const Triangle& triangle : engraving.mesh.triangles) expected.insert(turned(triangle));
  EXPECT_EQ(triangles, expected);
}

TEST(ReplayCommand, TakesSettingsFromTheCommandLine) {
  const Engraving engraving;
  const double depth = engraving.depth({});
  EXPECT_NEAR(depth, 0.25 * 0.2, 0.005);
  EXPECT_NEAR(engraving.depth({"--strength", "0.5"}), depth / 2, 1e-3);
  EXPECT_NEAR(engraving.depth({"--param", "depth=0.5"}), 2 * depth, 1e-3);
  EXPECT_NEAR(engraving.depth({"--param", "depth=0.5", "--param", "taper=0"}), 2 * depth, 1e-2);
  EXPECT_EQ(engraving.moved({"--strength", "0"}), 0u);
  const std::size_t moved = engraving.moved({});
  EXPECT_GT(engraving.moved({"--radius", "0.3"}), moved * 5 / 4);
  EXPECT_GT(engraving.moved({"--param", "profile=flat"}), 0u);
}

TEST(ReplayCommand, GivesABrushToStrokesWithoutOne) {
  Engraving engraving;
  engraving.stroke = engraving.folder.write("bare.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.2"));
  EXPECT_GT(engraving.depth({"--brush", "org.burin.groove"}), 0.04);
}

TEST(ReplayCommand, DrawsSeveralFilesIntoOneSurface) {
  const Engraving engraving;
  const std::string second = engraving.folder.write("b.stroke", equator_stroke(1, 2, 21, groove));
  const json both = burin_json({"replay", engraving.stroke, second, "--mesh", engraving.mesh_path});
  EXPECT_EQ(both["strokes"], 2);
  EXPECT_EQ(both["events"], 82);
  EXPECT_NE(both["result_hash"], burin_json(engraving.command({}))["result_hash"]);
}

/// The first processors that this process may run on.
std::vector<std::string> processors(std::size_t count) {
  cpu_set_t allowed;
  sched_getaffinity(0, sizeof allowed, &allowed);
  std::vector<std::string> found;
  for (std::size_t i = 0; i < CPU_SETSIZE && found.size() < count; ++i) {
    if (CPU_ISSET(i, &allowed)) found.push_back(std::to_string(i));
  }
  return found;
}

TEST(ReplayCommand, GivesTheSameBitsOnOneAndTwoProcessors) {
  const std::vector<std::string> cpus = processors(2);
  if (cpus.size() < 2) GTEST_SKIP() << "one processor only";
  const Engraving engraving;
  const std::string second = engraving.folder.write("b.stroke", equator_stroke(-0.3, 0.2, 31, groove));
  const auto hash = [&](const std::string& list) {
    const ProcessResult result =
        run_process({"taskset", "-c", list, BURIN_COMMAND, "replay", engraving.stroke, second, "--mesh",
                     engraving.mesh_path, "--json"},
                    {"BURIN_PLUGIN_PATH="});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out)["result_hash"];
  };
  EXPECT_EQ(hash(cpus[0]), hash(cpus[0] + "," + cpus[1]));
}

TEST(ReplayCommand, WritesAReportWithPictures) {
  const Engraving engraving;
  const std::string folder = engraving.folder.path("new/report");
  const json result =
      burin_json(engraving.command({"--report", folder, "--width", "300", "--height", "225"}));
  const json reported = json::parse(read_file(folder + "/report.json"));
  EXPECT_EQ(reported, result);
  const Picture before = read_png(folder + "/before.png"), after = read_png(folder + "/after.png"),
                chart = read_png(folder + "/chart.png");
  const auto pixels = [](const Picture& picture, const auto& test) {
    int count = 0;
    for (int row = 0; row < picture.height; row += 3) {
      for (int column = 0; column < picture.width; column += 3) count += test(column, row) ? 1 : 0;
    }
    return count;
  };
  const int all = pixels(before, [](int, int) { return true; });
  const auto differs = [&](int x, int y) { return pixel(before, x, y) != pixel(after, x, y); };
  EXPECT_GT(pixels(before, differs), all / 20) << "the groove fills a good part of the picture";
  EXPECT_GT(pixels(chart, [&](int x, int y) { return pixel(chart, x, y)[0] > pixel(chart, x, y)[2] + 90; }),
            all / 100);
  EXPECT_GT(pixels(chart, [&](int x, int y) { return pixel(chart, x, y)[2] > pixel(chart, x, y)[0] + 40; }),
            all / 100);
  const std::string html = read_file(folder + "/index.html");
  for (const char* part : {"before.png", "after.png", "chart.png", "<svg", "p99"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
}

TEST(ReplayCommand, CountsTheDefectsOfAMesh) {
  const CommandFolder folder;
  const std::string mesh = folder.write("nasty.obj", obj_text(sphere(3, 0, 1)) + "f 1 2 2\nf 3 4 5\n");
  const std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, groove));
  const ProcessResult result = burin({"replay", stroke, "--mesh", mesh, "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err.rfind("burin: warning: " + mesh + ": ", 0), 0u) << result.err;
  const json report = json::parse(result.out);
  EXPECT_NE(report["mesh"]["defects"].get<std::string>().find("1 degenerate"), std::string::npos);
  EXPECT_GT(report["events"], 10);
}

TEST(ReplayCommand, RefusesARecordingThatWasCutOffUntilItIsMended) {
  Engraving engraving;
  const std::string text = equator_stroke(-0.6, 0.6, 61, groove);
  const std::string cut = text.substr(0, text.size() - 20);
  ASSERT_NE(cut.back(), '\n');
  engraving.stroke = engraving.folder.write("cut.stroke", cut);
  const ProcessResult refused = burin(engraving.command({"--json"}));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err.rfind("burin: " + engraving.stroke + ":63: the recording is cut off here", 0), 0u)
      << refused.err;

  engraving.folder.write("cut.stroke", cut.substr(0, cut.rfind('\n') + 1) + "{\"end\": true}\n");
  const ProcessResult mended = burin(engraving.command({"--json"}));
  EXPECT_EQ(mended.exit_code, 0) << mended.err;
  EXPECT_EQ(json::parse(mended.out)["events"], 60);
}

TEST(ReplayCommand, WarnsWhenNoStrokeMeetsTheSurface) {
  Engraving engraving;
  engraving.mesh_path = engraving.folder.write("far.obj", "v 9 9 9\nv 9.3 9 9\nv 9 9.3 9\nf 1 2 3\n");
  const ProcessResult result = burin(engraving.command({}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "burin: warning: no stroke meets the surface\n");
}

/// A middle far from the image's values asks for displacements that the command refuses.
TEST(ReplayCommand, DrawsStampsWhoseMiddleIsFarFromTheirImage) {
  const CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(sphere(4, 0, 1)));
  const std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 21, "\"radius\":0.2"));
  const std::string stamps = std::string("stamp=") + BURIN_SAMPLES + "/stamps/";
  const std::vector<std::string> replay = {"replay", stroke, "--mesh", mesh, "--json"};
  const auto drawn = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = replay;
    words.insert(words.end(), options.begin(), options.end());
    return burin(words);
  };
  for (const char* middle : {"-65504", "65504"}) {
    const ProcessResult scales = drawn({"--brush", "org.burin.scales", "--param", stamps + "scales.exr",
                                        "--param", std::string("centre=") + middle, "--param", "depth=1"});
    EXPECT_EQ(scales.exit_code, 0) << scales.err;
    const ProcessResult thorns = drawn({"--brush", "org.burin.vdm-trail", "--param", stamps + "thorn.exr",
                                        "--param", std::string("middle=") + middle, "--param", "amount=1"});
    EXPECT_EQ(thorns.exit_code, 0) << thorns.err;
  }
}

}  // namespace
}  // namespace burin::test
