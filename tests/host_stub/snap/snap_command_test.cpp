#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_stub/picture_file.h"
#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// A plane of edges of about 1 with a ridge along y = 0, as PLY with a value per vertex, `dark`, that is
/// lowest on y = 5.
struct RidgeFile {
  CommandFolder folder;
  std::string mesh, stroke;

  static double height(double y) { return 2 * std::exp(-y * y / 18); }

  RidgeFile() {
    const TriangleMesh plane = shuffled(patch({-40, 40, -25, 25, 90, 56, false, 0.3, 0.3, 3},
                                              [](double x, double y) { return Vec3d(x, y, height(y)); }),
                                        4);
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "property float dark\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        plane.positions.size(), plane.triangles.size());
    for (const Vec3f& p : plane.positions)
      text += fmt::format("{} {} {} {}\n", p.x(), p.y(), p.z(),
                          100 - 50 * std::exp(-(p.y() - 5) * (p.y() - 5) / 18));
    for (const auto& [a, b, c] : plane.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
    mesh = folder.write("ridge.ply", text);
    text =
        "{\"burin_stroke\":1,\"space\":\"object\"}\n"
        "{\"begin\":{\"brush\":\"org.burin.groove\",\"radius\":12},\"fields\":[\"time\",\"x\",\"y\",\"z\","
        "\"pressure\"],\"tool\":\"pen\",\"eraser\":true}\n";
    for (int i = 0; i <= 30; ++i) {
      const double y = 3 + std::sin(i / 3.);
      text += fmt::format("[{},{},{},{},{}]\n", 0.01 * i, i * 2 - 30, y, height(y), 0.2 + 0.02 * i);
    }
    stroke = folder.write("a.stroke", text + "{\"end\":true}\n");
  }

  std::vector<std::string> arguments(const std::string& feature) const {
    return {"snap", stroke, "--mesh", mesh, "--feature", feature, "--out", folder.path("out.stroke")};
  }
};

/// The greatest distance of the samples of a recording's only stroke from y.
double farthest_from(const Recording& recording, double y) {
  double farthest = 0;
  for (const Sample& sample : recording.strokes[0].samples)
    farthest = std::max(farthest, std::abs(sample.position.y() - y));
  return farthest;
}

TEST(SnapCommand, WritesStrokesOnRidgesThatReplayDraws) {
  const RidgeFile ridge;
  const auto report = burin_json(ridge.arguments("ridge"));
  EXPECT_NEAR(report["strokes"][0]["snapped_share"], 1, 1e-6);
  EXPECT_NEAR(report["strokes"][0]["mean_move"], 3.3, 0.4) << "along the slope";
  EXPECT_GT(report["strokes"][0]["significance"], 5);
  EXPECT_EQ(report["strokes"][0]["iterations"], 2);
  const Recording recording = read_strokes(ridge.folder.path("out.stroke"));
  EXPECT_EQ(recording.space, StrokeSpace::object);
  ASSERT_EQ(recording.strokes.size(), 1u);
  EXPECT_LT(farthest_from(recording, 0), 0.3);
  const RecordedStroke& stroke = recording.strokes[0];
  EXPECT_TRUE(stroke.fields.time && stroke.fields.pressure && !stroke.fields.tilt);
  EXPECT_EQ(*stroke.settings.find(&ReplaySettings::brush), "org.burin.groove");
  EXPECT_EQ(*stroke.settings.find(&ReplaySettings::radius), 12);
  EXPECT_TRUE(stroke.drawn_by.eraser);
  EXPECT_EQ(stroke.drawn_by.tool, "pen");
  EXPECT_EQ(report["strokes"][0]["points"], stroke.samples.size());
  for (const Sample& sample : stroke.samples)
    EXPECT_NEAR(sample.pen.pressure, 0.2 + 0.02 * (sample.position.x() + 30) / 2, 0.01)
        << "the pen of the stroke";
  const auto replayed =
      burin_json({"replay", ridge.folder.path("out.stroke"), "--mesh", ridge.mesh, "--radius", "4"});
  EXPECT_GT(replayed["vertices_changed"], 0) << replayed.dump();
}

TEST(SnapCommand, FollowsValuesOfTheVerticesAndLeavesTheRestAlone) {
  const RidgeFile ridge;
  burin_output(ridge.arguments("scalar:-dark"));
  EXPECT_LT(farthest_from(read_strokes(ridge.folder.path("out.stroke")), 5), 0.3);
  const std::string text = burin_output(ridge.arguments("scalar:x"));
  EXPECT_NE(text.find("stroke 1: stays, nothing stands out"), std::string::npos) << text;
  EXPECT_NEAR(farthest_from(read_strokes(ridge.folder.path("out.stroke")), 3), 1, 0.05);
}

TEST(SnapCommand, FollowsTheCreasesOfACageWhereTheRefinedMeshHasNoEdge) {
  // A flat cage of 4 x 4 squares with a crease along its middle, x = 2, which bends nothing.
  const CommandFolder folder;
  std::string plain, creases;
  for (int i = 0; i < 25; ++i) plain += fmt::format("v {} {} 0\n", i % 5, i / 5);
  for (int y = 0; y < 4; ++y) {
    for (int x = 1; x <= 4; ++x)
      plain += fmt::format("f {} {} {} {}\n", y * 5 + x, y * 5 + x + 1, y * 5 + x + 6, y * 5 + x + 5);
    creases += fmt::format("t crease 2/1/0 {} {} 2\n", y * 5 + 2, y * 5 + 7);
  }
  std::string stroke =
      "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"brush\":\"org.burin.groove\","
      "\"radius\":0.6},\"fields\":[\"time\",\"x\",\"y\",\"z\"]}\n";
  for (int i = 0; i <= 30; ++i)
    stroke += fmt::format("[{},{},{},0]\n", 0.01 * i, 1.75 + 0.1 * std::sin(i / 4.), 0.5 + 0.1 * i);
  folder.write("a.stroke", stroke + "{\"end\":true}\n");
  const auto share_of = [&](const std::string& cage) {
    const auto report =
        burin_json({"snap", folder.path("a.stroke"), "--mesh", folder.write("cage.obj", cage), "--subdivide",
                    "4", "--feature", "crease", "--out", folder.path("out.stroke")});
    return report["strokes"][0]["snapped_share"].get<double>();
  };
  EXPECT_EQ(share_of(plain), 0);
  EXPECT_GT(share_of(plain + creases), 0.95);
  const Recording recording = read_strokes(folder.path("out.stroke"));
  ASSERT_GT(recording.strokes[0].samples.size(), 20u);
  for (const Sample& sample : recording.strokes[0].samples) EXPECT_NEAR(sample.position.x(), 2, 1e-5);
}

TEST(SnapCommand, DrawsTheStrokeBeforeAndAfter) {
  const RidgeFile ridge;
  auto arguments = ridge.arguments("ridge");
  for (const char* word : {"--width", "400", "--height", "300", "--png"}) arguments.push_back(word);
  arguments.push_back(ridge.folder.path("a.png"));
  burin_output(arguments);
  const Picture picture = read_png(ridge.folder.path("a.png"));
  std::size_t red = 0, black = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    red += picture.rgb[i] > 180 && picture.rgb[i + 1] < 60;
    black += picture.rgb[i] < 40 && picture.rgb[i + 1] < 40 && picture.rgb[i + 2] < 40;
  }
  EXPECT_GT(red, 300u);
  EXPECT_GT(black, 300u);
}

TEST(SnapCommand, FindsSilhouettesOfTheViewOrTheRecordedCamera) {
  CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(shuffled(sphere(5, 0.2, 7), 8)));
  const std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.3"));
  const std::string out = folder.path("out.stroke");
  // Seen from above, at 0.1 radians to it, the equator is nearly the silhouette.
  burin_output(
      {"snap", stroke, "--mesh", mesh, "--feature", "silhouette", "--view", "0,-1,-0.1", "--out", out});
  const Vec3d view = Vec3d(0, -1, -0.1).normalized();
  const Recording seen = read_strokes(out);
  for (const Sample& sample : seen.strokes[0].samples)
    EXPECT_NEAR(sample.position.normalized().dot(view), 0, 1e-3);
  const ProcessResult result =
      burin({"snap", stroke, "--mesh", mesh, "--feature", "silhouette", "--out", out});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("--view"), std::string::npos) << result.err;
}

/// A `.stroke` file of nothing but a camera that looks from (0, 10, 0) along -y.
std::string camera_file(const std::string& projection) {
  return "{\"burin_stroke\":1,\"space\":\"object\",\"camera\":{\"view\":[1,0,0,0, 0,0,1,0, 0,-1,0,0, "
         "0,0,-10,1],"
         "\"projection\":[" +
         projection + "],\"viewport\":[800,600]}}\n";
}

TEST(SnapCommand, FindsSilhouettesByTheLinesOfSightOfACamera) {
  CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(shuffled(sphere(5, 0.2, 7), 8)));
  const std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.3"));
  const std::string out = folder.path("out.stroke");
  const auto expect_seen_by = [&](const std::string& projection, const Vec3d& towards, double cosine) {
    const std::string camera = folder.write("camera.stroke", camera_file(projection));
    burin_output(
        {"snap", stroke, "--mesh", mesh, "--feature", "silhouette", "--camera", camera, "--out", out});
    const Recording seen = read_strokes(out);
    for (const Sample& sample : seen.strokes[0].samples)
      EXPECT_NEAR(sample.position.normalized().dot(towards), cosine, 1e-3) << projection;
  };
  // The middle of the picture is not where the camera looks, which does not move its eye.
  expect_seen_by("1,0,0,0, 0,1,0,0, 0.3,-0.2,-1.02,-1, 0,0,-0.2,0", Vec3d::UnitY(), 0.1);
  expect_seen_by("0.5,0,0,0, 0,0.5,0,0, 0,0,-0.1,0, 0,0,0,1", Vec3d::UnitY(), 0);
  // Parallel lines of sight that are not at right angles to the picture.
  expect_seen_by("0.5,0,0,0, 0,0.5,0,0, 0,0.05,-0.1,0, 0,0,0,1", Vec3d(0, 1, 0.1).normalized(), 0);
}

TEST(SnapCommand, FollowsLinesToANewView) {
  CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(shuffled(sphere(5, 0.2, 7), 8)));
  const std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.3"));
  const std::string line = folder.path("line.stroke"), out = folder.path("out.stroke");
  const std::vector<std::string> rest = {"--mesh", mesh, "--feature", "silhouette"};
  const auto arguments = [&](std::vector<std::string> words) {
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
  };
  burin_output(arguments({"snap", stroke, "--view", "0,-1,-0.1", "--out", line}));
  const std::string picture = folder.path("a.png");
  const auto report = burin_json(arguments({"snap", line, "--track", "2", "--view", "0,-1,-0.12", "--out",
                                            out, "--png", picture, "--width", "200", "--height", "150"}));
  ASSERT_EQ(report["strokes"][0]["followed"].size(), 1u) << report.dump();
  EXPECT_TRUE(report["strokes"][0]["lost"].empty()) << report.dump();
  EXPECT_NEAR(report["strokes"][0]["most_moved"], 0.02, 0.004);
  const auto samples = read_strokes(out).strokes[0].samples;
  for (const Sample& sample : samples) {
    EXPECT_NEAR(sample.position.normalized().dot(Vec3d(0, -1, -0.12).normalized()), 0, 1e-3);
    // The line turned about the x axis, so that points keep their x.
    EXPECT_NEAR(sample.position.x(), std::sin(-0.6 + 0.02 * sample.time / 0.01), 0.01) << "identity by time";
  }
  EXPECT_GT(samples.size(), 50u);
  const std::string text =
      burin_output(arguments({"snap", line, "--track", "0.5", "--view", "0,-1,-0.2", "--out", out}));
  EXPECT_NE(text.find("stroke 1: not followed; jumped from 0 to"), std::string::npos) << text;
  EXPECT_TRUE(read_strokes(out).strokes.empty());
}

TEST(SnapCommand, DrawsStrokesThatAreTooShortToSnap) {
  const RidgeFile ridge;
  const std::string stroke = ridge.folder.write(
      "dot.stroke",
      "{\"burin_stroke\":1,\"space\":\"object\"}\n"
      "{\"begin\":{\"radius\":12},\"fields\":[\"x\",\"y\",\"z\"]}\n[0,0,2]\n{\"end\":true}\n");
  const std::string text = burin_output({"snap", stroke, "--mesh", ridge.mesh, "--feature", "ridge", "--out",
                                         ridge.folder.path("out.stroke"), "--png", ridge.folder.path("a.png"),
                                         "--width", "64", "--height", "48"});
  EXPECT_NE(text.find("stroke 1: stays"), std::string::npos) << text;
}

}  // namespace
}  // namespace burin::test
