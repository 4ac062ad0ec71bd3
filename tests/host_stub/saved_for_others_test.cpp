// Checks that other programs read saved meshes, painted in part and masked, correctly: the same triangles,
// the same up axis, and the colours of Burin's pictures.

#include <burin/base/srgb.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "programs.h"
#include "run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// A corner of a triangle as another program reads it.
struct Corner {
  Vec3f place;
  std::array<std::uint8_t, 3> colour;  ///< sRGB
};

using Corners = std::vector<Corner>;

/// Reads lines "x y z r g b" in linear light, as the scripts in programs/ write them.
Corners read_corners(const std::string& path) {
  std::ifstream in(path);
  Corners corners;
  Vec3f p, c;
  while (in >> p.x() >> p.y() >> p.z() >> c.x() >> c.y() >> c.z())
    corners.push_back({p, {to_srgb(c.x()), to_srgb(c.y()), to_srgb(c.z())}});
  return corners;
}

/// The corners of a mesh file, with the appearance of its colours.
Corners corners_of(const PolygonMesh& mesh) {
  Corners corners;
  for (const Triangle& triangle : triangulate(mesh).triangles)
    for (const Index vertex : triangle) {
      const PaintBytes& colour = mesh.paint.colours.at(vertex);
      corners.push_back({mesh.positions[vertex], {colour[0], colour[1], colour[2]}});
    }
  return corners;
}

/// Ink over the clay of the pictures, whose linear light is 0.56, 0.41 and 0.32.
std::uint8_t blended(std::uint8_t ink, float coverage, float clay) {
  return to_srgb(coverage * from_srgb(ink) + (1 - coverage) * clay);
}

Corners expected_of(PolygonMesh mesh) {
  for (PaintBytes& colour : mesh.paint.colours) {
    const float coverage = static_cast<float>(colour[3]) / 255;
    colour = {blended(colour[0], coverage, 0.56F), blended(colour[1], coverage, 0.41F),
              blended(colour[2], coverage, 0.32F), 255};
  }
  return corners_of(mesh);
}

/// Rotates corners from y up to z up.
Corners turned(Corners corners) {
  for (Corner& corner : corners) corner.place = {corner.place.x(), -corner.place.z(), corner.place.y()};
  return corners;
}

/// Decodes sRGB once more, for a program that takes linear light for sRGB.
Corners linear(Corners corners) {
  for (Corner& corner : corners)
    for (std::uint8_t& channel : corner.colour)
      channel = static_cast<std::uint8_t>(std::lround(255 * from_srgb(channel)));
  return corners;
}

constexpr float rounding = 2e-6F;  ///< of places as text

/// Triangle by triangle, which may begin with another corner; colours off by so many steps at most.
void expect_same(const Corners& seen, const Corners& expected, int steps = 1) {
  ASSERT_EQ(seen.size(), expected.size());
  for (std::size_t i = 0; i < seen.size(); i += 3) {
    std::size_t first = 0;
    while (first < 2 && (seen[i + first].place - expected[i].place).norm() > rounding) ++first;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Corner &other = seen[i + (first + corner) % 3], &own = expected[i + corner];
      ASSERT_LT((other.place - own.place).norm(), rounding) << i;
      for (std::size_t channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(other.colour[channel], own.colour[channel], steps) << i;
    }
  }
}

void run_well(const std::vector<std::string>& command) {
  const ProcessResult result = run_process(command, {"XDG_RUNTIME_DIR=/tmp"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

/// A body without symmetry with half transparent, protected dashes in relief, saved from y up.
class SavedForOthers : public testing::Test {
 protected:
  SavedForOthers() {
    for (Vec3f& place : mesh.positions)
      place = place.cwiseProduct(Vec3f(1, 0.7F, 1.3F)) + Vec3f(0.2F, 0.1F, 0);
    saved("a.ply", "y-up");
    const PolygonMesh own = read_mesh(folder.path("a.ply"));
    expected = expected_of(own);
    const auto is_partial = [](const PaintBytes& colour) { return colour[3] > 100 && colour[3] < 150; };
    EXPECT_GT(std::ranges::count_if(own.paint.colours, is_partial), 50);
    EXPECT_GT(std::ranges::count(own.paint.masks, 0.0F), 50);
  }

  std::string saved(const std::string& name, const std::string& axes) {
    burin_output({"replay", stroke, "--mesh", folder.write("body.obj", obj_text(mesh)), "--axes", axes,
                  "--brush", "org.burin.dashed-line", "--param", "width=0.8", "--param", "height=0.1",
                  "--param", "colour=0.05,0.2,0.5,0.5", "--param", "mask=1", "--save-mesh",
                  folder.path(name)});
    return folder.path(name);
  }

  Corners blender(const std::string& file) const {
    run_well({"blender", "--background", "--factory-startup", "--python",
              BURIN_TESTS "/host_stub/programs/blender_corners.py", "--", file, folder.path("corners")});
    return read_corners(folder.path("corners"));
  }

  Corners three(const std::string& file) const {
    run_well({"node", BURIN_TESTS "/host_stub/programs/three_corners.mjs", file, folder.path("corners")});
    return read_corners(folder.path("corners"));
  }

  Corners mesh_lab(const std::string& file) const {
    run_well({"xvfb-run", "-a", "-s", "-screen 0 640x480x24", "meshlabserver", "-i", file, "-o",
              folder.path("lab.ply"), "-m", "vc"});
    return corners_of(read_mesh(folder.path("lab.ply")));
  }

  Corners assimp(const std::string& file) const {
    // The text format is used, since the program's binary files declare another colour type than they hold.
    run_well({"assimp", "export", file, folder.path("assimp.ply"), "-fply"});
    return corners_of(read_mesh(folder.path("assimp.ply")));
  }

  CommandFolder folder;
  TriangleMesh mesh = shuffled(sphere(4, 0.2, 3), 4);
  std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"radius\":0.3"));
  Corners expected;  ///< y up
};

TEST_F(SavedForOthers, OpenInBlender) {
  if (!is_installed("blender")) GTEST_SKIP() << not_installed("blender");
  expect_same(blender(saved("b.ply", "y-up:z-up")), turned(expected));
  expect_same(blender(saved("b.obj", "y-up")), turned(expected));
  expect_same(blender(saved("b.glb", "y-up")), turned(expected));
}

TEST_F(SavedForOthers, OpenInThreeJs) {
  if (!is_installed("node")) GTEST_SKIP() << not_installed("node");
  if (!std::filesystem::exists(BURIN_TESTS "/host_stub/programs/node_modules/three"))
    GTEST_SKIP() << not_installed("three.js");
  for (const char* name : {"b.ply", "b.obj", "b.glb"}) expect_same(three(saved(name, "y-up")), expected);
}

TEST_F(SavedForOthers, OpenInMeshLab) {
  if (!is_installed("meshlabserver") || !is_installed("xvfb-run")) GTEST_SKIP() << not_installed("MeshLab");
  for (const char* name : {"b.ply", "b.off"}) expect_same(mesh_lab(saved(name, "y-up")), expected);
}

TEST_F(SavedForOthers, OpenInAssimp) {
  if (!is_installed("assimp")) GTEST_SKIP() << not_installed("assimp");
  expect_same(assimp(saved("b.ply", "y-up")), expected);
  expect_same(assimp(saved("b.obj", "y-up")), expected);
  // A step of sRGB is up to 2.3 steps of linear light.
  expect_same(assimp(saved("b.glb", "y-up")), linear(expected), 2);
}

}  // namespace
}  // namespace burin::test
