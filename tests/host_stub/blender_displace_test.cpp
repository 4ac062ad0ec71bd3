// Applies baked maps by Blender's Displace modifier and by the displacement of Cycles, if Blender is
// installed.

#include <burin/surface/mesh_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "programs.h"
#include "run_command.h"

namespace burin::test {
namespace {

/// Half a cylinder of radius 1 with texture coordinates 0.05 to 0.95: points (sin a, y, cos a).
std::string half_pipe(int cells) {
  std::string text;
  const auto each = [&](const auto& put) {
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) put(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
  };
  each([&](double u, double v) {
    const double angle = std::numbers::pi * (u - 0.5);
    text += fmt::format("v {} {} {}\n", std::sin(angle), 2 * v - 1, std::cos(angle));
  });
  each([&](double u, double v) { text += fmt::format("vt {} {}\n", 0.05 + 0.9 * u, 0.05 + 0.9 * v); });
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i + 1, b = a + 1, c = b + cells + 1, d = c - 1;
      text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\nf {0}/{0} {2}/{2} {3}/{3}\n", a, b, c, d);
    }
  return text;
}

std::string slanted_stroke() {
  std::string text =
      "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"radius\":0.4},\"fields\":[\"time\",\"x\","
      "\"y\","
      "\"z\"]}\n";
  for (int i = 0; i <= 60; ++i) {
    const double angle = -0.7 + 1.4 * i / 60;
    text += fmt::format("[{},{},{},{}]\n", 0.01 * i, std::sin(angle), 0.2 * angle, std::cos(angle));
  }
  return text + "{\"end\":true}\n";
}

std::vector<Vec3f> read_points(const std::string& path) {
  std::ifstream in(path);
  std::vector<Vec3f> points;
  for (Vec3f point; in >> point.x() >> point.y() >> point.z();) points.push_back(point);
  return points;
}

/// Greatest distance of Blender's vertices from Burin's, in parts of the greatest displacement.
double error_of(const CommandFolder& folder, const std::vector<std::string>& options,
                const std::string& script, const std::string& direction) {
  const std::string mesh = folder.write("pipe.obj", half_pipe(160)), map = folder.path("map.exr");
  std::vector<std::string> arguments = {"replay",      folder.write("a.stroke", slanted_stroke()),
                                        "--mesh",      mesh,
                                        "--bake",      map,
                                        "--bake-size", "2048",
                                        "--save-mesh", folder.path("out.ply")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  burin_output(arguments);
  const ProcessResult result = run_process({"blender", "--background", "--factory-startup", "--python",
                                            BURIN_TESTS "/host_stub/programs/" + script, "--", mesh, map,
                                            direction, folder.path("points")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::vector<Vec3f> base = read_mesh(mesh).positions,
                           moved = read_mesh(folder.path("out.ply")).positions,
                           points = read_points(folder.path("points"));
  if (points.size() != base.size() || moved.size() != base.size()) throw std::runtime_error(result.out);
  float depth = 0, off = 0;
  for (std::size_t i = 0; i < base.size(); ++i) {
    depth = std::max(depth, (moved[i] - base[i]).norm());
    off = std::max(off, (points[i] - moved[i]).norm());
  }
  EXPECT_GT(depth, 0.05F);
  std::cout << script << ' ' << direction << ": off by at most " << 100 * off / depth << " % of " << depth
            << "\n";
  return double{off} / double{depth};
}

const std::vector<std::string> heights = {"--brush", "org.burin.groove"};

std::vector<std::string> vectors(const std::string& axes) {
  return {"--brush",        "org.burin.vdm-trail", "--param", "stamp=" BURIN_SAMPLES "/stamps/thorn.exr",
          "--bake-vectors", "--bake-axes",         axes};
}

TEST(BlenderDisplace, GivesTheSurfaceThatBurinHas) {
  if (!is_installed("blender")) GTEST_SKIP() << not_installed("blender");
  const CommandFolder folder;
  EXPECT_LT(error_of(folder, heights, "blender_displace.py", "NORMAL"), 0.005);
  EXPECT_LT(error_of(folder, vectors("object"), "blender_displace.py", "RGB_TO_XYZ"), 0.005);
}

TEST(CyclesDisplacement, GivesTheSurfaceThatBurinHas) {
  if (!is_installed("blender")) GTEST_SKIP() << not_installed("blender");
  const CommandFolder folder;
  EXPECT_LT(error_of(folder, heights, "cycles_displace.py", "NORMAL"), 0.005);
  EXPECT_LT(error_of(folder, vectors("object"), "cycles_displace.py", "OBJECT"), 0.005);
  EXPECT_LT(error_of(folder, vectors("cycles"), "cycles_displace.py", "TANGENT"), 0.005);
}

}  // namespace
}  // namespace burin::test
