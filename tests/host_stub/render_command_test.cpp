#include <burin/stroke/camera.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "picture_file.h"
#include "run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

int count_covered(const Picture& picture) {
  int count = 0;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) count += covered(picture, column, row) ? 1 : 0;
  }
  return count;
}

double brightness(const Picture& picture, int column, int row) {
  const Rgb rgb = pixel(picture, column, row);
  return rgb[0] + rgb[1] + rgb[2];
}

/// Radius in pixels of the unit sphere's outline.
double outline_radius(const Camera& camera) {
  const double distance = -camera.view(2, 3);
  return camera.height / 2.0 * camera.projection(1, 1) * std::tan(std::asin(1 / distance));
}

TEST(RenderCommand, ShowsTheSphereAsALitDiscOfItsSize) {
  const CommandFolder folder;
  const std::string mesh = folder.write("sphere.obj", obj_text(sphere(5, 0, 1)));
  burin_output({"render", "--mesh", mesh, "--png", folder.path("a.png"), "--view", "0,0,-1", "--fov", "30",
                "--width", "320", "--height", "240"});
  const Picture picture = read_png(folder.path("a.png"));
  ASSERT_EQ(picture.width, 320);
  ASSERT_EQ(picture.height, 240);
  const Vec3d corner = Vec3d::Ones();
  const double radius = outline_radius(framing_camera(-corner, corner, -Vec3d::UnitZ(), Vec3d::UnitY(), 320,
                                                      240, 30 * std::numbers::pi / 180));
  ASSERT_GT(radius, 40);
  for (const int column : {0, 319}) {
    for (const int row : {0, 239}) EXPECT_FALSE(covered(picture, column, row));
  }
  const double area = std::numbers::pi * radius * radius;
  EXPECT_NEAR(count_covered(picture), area + std::numbers::pi * radius, 0.02 * area)
      << "one pixel more at the rim";
  const int r = static_cast<int>(radius);
  for (const int offset : {-(r - 3), 0, r - 3}) {
    EXPECT_TRUE(covered(picture, 160 + offset, 120));
    EXPECT_TRUE(covered(picture, 160, 120 + offset));
  }
  EXPECT_FALSE(covered(picture, 160 + r + 3, 120));
  EXPECT_GT(brightness(picture, 160 - r / 2, 120 - r / 2), brightness(picture, 160 + r / 2, 120 + r / 2) + 60)
      << "the key light stands at the upper left";
}

TEST(RenderCommand, LooksAlongTheView) {
  const CommandFolder folder;
  const std::string mesh = folder.write("plane.obj", obj_text(plane(1, 0.2, 1)));
  for (const auto& [view, lowest, highest] :
       {std::tuple("0,0,-1", 5000, 60000), std::tuple("1,0,0", 0, 400)}) {
    burin_output({"render", "--mesh", mesh, "--png", folder.path("a.png"), "--view", view, "--width", "300",
                  "--height", "200"});
    const int count = count_covered(read_png(folder.path("a.png")));
    EXPECT_GE(count, lowest) << view;
    EXPECT_LE(count, highest) << view;
  }
}

TEST(RenderCommand, DrawsCrevicesDarker) {
  const CommandFolder folder;
  // A floor in a deep square well is seen from above, as the ground around it is.
  // Every face has vertices of its own, a hair from the others', and none are joined, so that shading is
  // flat.
  std::string obj;
  int vertices = 0;
  const auto face = [&](std::initializer_list<std::array<double, 3>> corners) {
    const double hair = 1 + 1e-6 * vertices;
    for (const auto& [x, y, z] : corners) obj += fmt::format("v {} {} {}\n", hair * x, hair * y, hair * z);
    obj += fmt::format("f {} {} {} {}\n", vertices + 1, vertices + 2, vertices + 3, vertices + 4);
    vertices += 4;
  };
  constexpr double a = 4, b = 0.3, deep = -0.6;
  const std::array<std::array<double, 2>, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [x, y] = corners[i];
    const auto [u, v] = corners[(i + 1) % 4];
    face({{a * x, a * y, 0}, {a * u, a * v, 0}, {b * u, b * v, 0}, {b * x, b * y, 0}});
    face({{b * x, b * y, 0}, {b * u, b * v, 0}, {b * u, b * v, deep}, {b * x, b * y, deep}});
  }
  face({{-b, -b, deep}, {b, -b, deep}, {b, b, deep}, {-b, b, deep}});
  const std::string mesh = folder.write("well.obj", obj);
  burin_output({"render", "--mesh", mesh, "--png", folder.path("a.png"), "--view", "0,0,-1", "--width", "300",
                "--height", "200", "--weld", "0"});
  const Picture picture = read_png(folder.path("a.png"));
  EXPECT_LT(brightness(picture, 150, 100), 0.8 * brightness(picture, 150, 70));
}

TEST(RenderCommand, TellsWhatItDrew) {
  const CommandFolder folder;
  const std::string cage = folder.write("cube.obj", cube_obj());
  const auto json = burin_json({"render", "--mesh", cage, "--subdivide", "2", "--png", folder.path("a.png"),
                                "--width", "64", "--height", "48"});
  EXPECT_EQ(json["mesh"]["triangles"], 6 * 16 * 2);
  EXPECT_EQ(json["mesh"]["vertices"], 98);
  EXPECT_EQ(json["png"], folder.path("a.png"));
}

TEST(MeshOptions, ChooseTheLevelByTriangles) {
  const CommandFolder folder;
  const std::string cage = folder.write("cube.obj", cube_obj());
  const auto triangles = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"render",  "--mesh", cage,       "--png", folder.path("a.png"),
                                          "--width", "16",     "--height", "16"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return burin_json(arguments)["mesh"]["triangles"].get<int>();
  };
  EXPECT_EQ(triangles({}), 12);
  EXPECT_EQ(triangles({"--target-triangles", "48"}), 48);
  EXPECT_EQ(triangles({"--target-triangles", "49"}), 192);
  EXPECT_EQ(triangles({"--subdivide", "1", "--scheme", "catmull-clark"}), 48);
}

TEST(MeshOptions, RefineTrianglesByLoopUnlessToldOtherwise) {
  const CommandFolder folder;
  const std::string cage = folder.write("tetrahedron.obj",
                                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                        "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const auto triangles = [&](const std::string& scheme) {
    return burin_json({"render", "--mesh", cage, "--subdivide", "1", "--scheme", scheme, "--png",
                       folder.path("a.png"), "--width", "16", "--height", "16"})["mesh"]["triangles"]
        .get<int>();
  };
  EXPECT_EQ(triangles("auto"), 16);
  EXPECT_EQ(triangles("loop"), 16);
  EXPECT_EQ(triangles("catmull-clark"), 24);
}

}  // namespace
}  // namespace burin::test
