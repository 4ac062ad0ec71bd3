// `burin replay --refine`: what it draws on a box of 12 triangles, says and refuses.
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "../picture_file.h"
#include "../run_command.h"
#include "support/point_shapes.h"

namespace burin::test {
namespace {

/// A box of 2 x 1 x 1 as an STL file of 12 triangles, and a stroke over its top.
struct Box {
  CommandFolder folder;
  std::string mesh = folder.write("box.stl", stl_text());
  std::string stroke = folder.write("a.stroke", stroke_text());
  std::string saved = folder.path("out.ply");

  static std::string stl_text() {
    const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    std::string text = "solid box\n";
    for (const auto& face : faces) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int i : face)
        text += fmt::format("vertex {} {} {}\n", i & 1 ? 2 : 0, i >> 1 & 1, i >> 2 & 1);
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
  }
  static std::string stroke_text() {
    std::string text =
        "{\"burin_stroke\":1,\"space\":\"object\"}\n"
        "{\"begin\":{\"brush\":\"org.burin.groove\",\"radius\":0.12},\"fields\":[\"x\",\"y\",\"z\"]}\n";
    for (int i = 0; i <= 40; ++i) text += fmt::format("[{},0.5,1]\n", 0.4 + 0.03 * i);
    return text + "{\"end\":true}\n";
  }
  std::vector<std::string> command(const std::vector<std::string>& options) const {
    std::vector<std::string> all = {"replay", stroke, "--mesh", mesh, "--save-mesh", saved};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }
  /// The line with which the command refuses the options.
  std::string refusal(const std::vector<std::string>& options) const {
    const ProcessResult result = burin(command(options));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(saved));
    return result.err;
  }
};

TEST(Refine, DrawsAGrooveOnABoxAndSaysWhatItAdded) {
  const Box box;
  const nlohmann::json result = burin_json(box.command({}));
  const TriangleMesh mesh = triangulate(read_mesh(box.saved));
  ASSERT_EQ(result["refined"].size(), 1u);
  EXPECT_EQ(result["refined"][0]["triangles_added"], mesh.triangles.size());
  EXPECT_EQ(result["refined"][0]["triangles_removed"], 12);
  EXPECT_GE(result["refined"][0]["seconds"]["split"], 0.0);
  float deepest = 1;
  for (const Vec3f& p : mesh.positions)
    if (p.x() > 0.8F && p.x() < 1.2F && p.y() > 0.4F && p.y() < 0.6F && p.z() > 0.8F)
      deepest = std::min(deepest, p.z());
  EXPECT_NEAR(deepest, 1 - 0.25F * 0.12F, 1e-4F);
  const std::string text = burin_output(box.command({}));
  EXPECT_NE(
      text.find(fmt::format("\nrefined         {} triangles in place of 12, with edges of about 0.0075, in",
                            mesh.triangles.size())),
      std::string::npos)
      << text;
}

TEST(Refine, WritesAReportOfSeveralStrokes) {
  const Box box;
  const std::string report = box.folder.path("report");
  std::vector<std::string> command = box.command({"--report", report});
  command.insert(command.begin() + 1, box.stroke);
  const ProcessResult result = burin(command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("\nrefined "), std::string::npos) << result.out;
  EXPECT_TRUE(std::filesystem::exists(report + "/chart.png"));
}

TEST(Refine, IsOffWhereTheCommandSaysSoOrBakes) {
  const Box box;
  const auto is_refined = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command = box.command(options);
    command.push_back("--json");
    return nlohmann::json::parse(burin(command).out).contains("refined");
  };
  EXPECT_FALSE(is_refined({"--refine", "off"}));
  EXPECT_EQ(read_mesh(box.saved).face_sizes.size(), 12u);
  EXPECT_FALSE(is_refined({"--sculpt-level", "0"}));
}

// Triangles are small on one side of an edge and large on the other: normals of vertices lean to one of both.
TEST(Refine, LeavesFacesFlatInPictures) {
  const Box box;
  const std::string path = box.folder.path("a.png");
  burin_output(box.command(
      {"--strength", "0", "--png", path, "--view", "0,0,-1", "--width", "160", "--height", "120"}));
  const Picture picture = read_png(path);
  constexpr int margin = 2;
  const auto is_clay = [&](int column, int row) {
    const Rgb rgb = pixel(picture, column, row);
    return rgb[0] > rgb[2] + 20;
  };
  int count = 0, least = 255, most = 0;
  for (int row = margin; row < picture.height - margin; ++row)
    for (int column = margin; column < picture.width - margin; ++column) {
      bool is_within = true;
      for (const int i : {-margin, 0, margin})
        for (const int j : {-margin, 0, margin}) is_within &= is_clay(column + i, row + j);
      if (!is_within) continue;
      ++count;
      least = std::min<int>(least, pixel(picture, column, row)[0]);
      most = std::max<int>(most, pixel(picture, column, row)[0]);
    }
  EXPECT_GT(count, 5000);
  EXPECT_LT(most - least, 20);
}

// Three strokes side by side and one over the first: what they need is made before the first is drawn.
TEST(Refine, RefinesOnceForARecording) {
  const Box box;
  std::string text = "{\"burin_stroke\":1,\"space\":\"object\"}\n";
  for (const double y : {0.2, 0.5, 0.8, 0.2}) {
    text += "{\"begin\":{\"brush\":\"org.burin.bead\",\"radius\":0.12},\"fields\":[\"x\",\"y\",\"z\"]}\n";
    for (int i = 0; i <= 40; ++i) text += fmt::format("[{},{},1]\n", 0.4 + 0.03 * i, y);
    text += "{\"end\":true}\n";
  }
  const std::string strokes = box.folder.write("four.stroke", text);
  const nlohmann::json result = burin_json({"replay", strokes, "--mesh", box.mesh});
  EXPECT_EQ(result["strokes"], 4);
  EXPECT_EQ(result["refined"].size(), 1u);
}

// A wide stroke over a narrow one, twice: triangles are taken out once, and the report tells how many.
TEST(Refine, TakesOutWhatAWiderStrokeDoesNotNeed) {
  const Box box;
  std::string text = "{\"burin_stroke\":1,\"space\":\"object\"}\n";
  for (const double radius : {0.03, 0.2, 0.2}) {
    text += fmt::format(
        "{{\"begin\":{{\"brush\":\"org.burin.bead\",\"radius\":{}}},"
        "\"fields\":[\"x\",\"y\",\"z\"]}}\n",
        radius);
    for (int i = 0; i <= 40; ++i) text += fmt::format("[{},0.5,1]\n", 0.4 + 0.03 * i);
    text += "{\"end\":true}\n";
  }
  const std::string strokes = box.folder.write("three.stroke", text);
  const nlohmann::json result =
      burin_json({"replay", strokes, "--mesh", box.mesh, "--save-mesh", box.saved})["refined"];
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(result[0]["vertices_removed"], 0);
  EXPECT_GT(result[1]["vertices_removed"], 1000);
  EXPECT_GT(result[1]["seconds"]["collapse"], 0.0);
  long count = 12;
  for (const auto& stroke : result)
    count += stroke["triangles_added"].get<long>() - stroke["triangles_removed"].get<long>();
  EXPECT_EQ(read_mesh(box.saved).face_sizes.size(), static_cast<std::size_t>(count));
}

// A stroke that would take more than a million triangles was hardly meant.
TEST(Refine, DeclinesWhatTakesTooManyTriangles) {
  const Box box;
  const ProcessResult result = burin(box.command({"--radius", "0.0005"}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(
      result.err,
      "burin: warning: a stroke of radius 0.0005 is drawn on the triangles that are there: to refine them "
      "would take about 4.6e+06, more than 1000000\n");
  EXPECT_EQ(read_mesh(box.saved).face_sizes.size(), 12u);
}

// Strokes whose triangles suit them have the bits that they have without refinement, also over each other.
TEST(Refine, ChangesNothingOnFineMeshes) {
  const std::string strokes = BURIN_SAMPLES "/strokes/";
  const auto hash_of = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command = {"replay",
                                        strokes + "meander.stroke",
                                        strokes + "wave.stroke",
                                        strokes + "meander.stroke",
                                        "--mesh",
                                        BURIN_SAMPLES "/meshes/ewer.obj",
                                        "--subdivide",
                                        "3",
                                        "--strength",
                                        "4"};
    command.insert(command.end(), options.begin(), options.end());
    return burin_json(command)["result_hash"];
  };
  EXPECT_EQ(hash_of({}), hash_of({"--refine", "off"}));
}

TEST(Refine, RefusesInOneLine) {
  const Box box;
  for (const char* length : {"edge:0", "edge:-1", "edge:nan", "edge:inf", "edge:", "edge:1x", "edge",
                             "0.0001", "0.6", "0.01x", "nan"})
    EXPECT_NE(box.refusal({"--refine", length})
                  .find("--refine: must be auto, off, edge:LENGTH, above 0, or an error from 0.001 to 0.5"),
              std::string::npos)
        << length;
  EXPECT_NE(box.refusal({"--refine", "edge:1e-6"})
                .find("stroke 1: refining the surface to edges of 1e-06 would take about 1.2e+12 triangles, "
                      "more than "
                      "10000000"),
            std::string::npos);
  EXPECT_NE(box.refusal({"--refine", "auto", "--bake", box.folder.path("a.exr")}).find("burin: "),
            std::string::npos);
  Box points;
  points.mesh = points.folder.write("points.ply", ply_text(plane_points(1, 0.1, 1)));
  EXPECT_NE(points.refusal({"--refine", "auto"}).find("points.ply: "), std::string::npos);
}

}  // namespace
}  // namespace burin::test
