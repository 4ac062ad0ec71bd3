#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

using Colours = std::vector<std::array<std::uint8_t, 4>>;

/// A triangle whose vertices have these properties besides their places, and these values, a vertex a string.
std::string triangle_text(const std::string& properties, const std::array<std::string, 3>& values) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
         properties + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 " +
         values[0] + "\n1 0 0 " + values[1] + "\n0 1 0 " + values[2] + "\n3 0 1 2\n";
}

VertexPaint paint_of(const std::string& properties, const std::array<std::string, 3>& values) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.ply";
  write_file_whole(path, [&](std::ostream& out) { out << triangle_text(properties, values); });
  return read_mesh(path).paint;
}

std::string rgb(const std::string& type) {
  return "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
}

std::string validation_error(const std::string& properties, const std::string& second) {
  try {
    paint_of(properties, {"0 0 0", second, "0 0 0"});
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(what.find("a.ply:") + 6);
  }
  return "no error";
}

TEST(PlyPaint, ReadsColoursByTheirInitials) {
  EXPECT_EQ(paint_of("property uchar r\nproperty uchar g\nproperty uchar b\nproperty uchar a\n",
                     {"1 2 3 255", "4 5 6 255", "7 8 9 0"})
                .colours,
            (Colours{{1, 2, 3, 255}, {4, 5, 6, 255}, {7, 8, 9, 0}}));
  EXPECT_TRUE(paint_of("property float r\nproperty float a\n", {"7 2", "7 2", "7 2"}).empty());
}

TEST(PlyPaint, ComesBackAsItWasWritten) {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = test::torus(40, 20);
  VertexPaint paint;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    paint.colours.push_back(
        {byte, static_cast<std::uint8_t>(255 - byte), 7, static_cast<std::uint8_t>(3 * i)});
    paint.masks.push_back(static_cast<float>(i) / 799);
  }
  const auto path = folder.path() / "a.ply";
  for (const bool coloured : {false, true}) {
    for (const bool masked : {false, true}) {
      const VertexPaint given{coloured ? paint.colours : Colours(),
                              masked ? paint.masks : std::vector<float>()};
      write_mesh(path, mesh, given);
      const PolygonMesh back = read_mesh(path);
      EXPECT_EQ(back.paint.colours, given.colours);
      EXPECT_EQ(back.paint.masks, given.masks);
      EXPECT_EQ(back.positions, mesh.positions);
    }
  }
}

TEST(PlyPaint, TakesEveryTypeOfChannel) {
  const Colours expected = {{255, 0, 51, 255}, {0, 255, 0, 255}, {1, 2, 3, 255}};
  EXPECT_EQ(paint_of(rgb("uchar"), {"255 0 51", "0 255 0", "1 2 3"}).colours, expected);
  EXPECT_EQ(paint_of(rgb("int"), {"255 0 51", "0 255 0", "1 2 3"}).colours, expected);
  EXPECT_EQ(paint_of(rgb("ushort"), {"65535 0 13107", "0 65535 0", "257 514 771"}).colours, expected);
  EXPECT_EQ(paint_of(rgb("float"), {"1 0 0.2", "0 1 0", "0.00392 0.00784 0.0118"}).colours, expected);
  EXPECT_EQ(
      paint_of(rgb("double") + "property double alpha\n", {"1 0 .2 1", "0 1 0 1", "0 0 0 0.2"}).colours[2],
      (Colours::value_type{0, 0, 0, 51}));
}

TEST(PlyPaint, TakesRealChannelsThatCountTo255) {
  const Colours expected = {{255, 0, 51, 255}, {0, 255, 0, 255}, {1, 2, 3, 255}};
  EXPECT_EQ(paint_of(rgb("float"), {"255.0 0.0 51.0", "0 255 0", "1 2 3"}).colours, expected);
  EXPECT_EQ(paint_of(rgb("double"), {"254.7 0 50.9", "0 255 0", "1.2 2 3"}).colours, expected);
  EXPECT_EQ(paint_of(rgb("float"), {"1 0 1", "0 2 0", "0 0 0"}).colours,
            (Colours{{1, 0, 1, 255}, {0, 2, 0, 255}, {0, 0, 0, 255}}));
  const std::string alpha = "property float alpha\n";
  EXPECT_EQ(paint_of(rgb("float") + alpha, {"9 0 0 1", "0 9 0 .2", "0 0 9 0"}).colours,
            (Colours{{9, 0, 0, 255}, {0, 9, 0, 51}, {0, 0, 9, 0}}));
  EXPECT_EQ(paint_of(rgb("float") + alpha, {"1 0 0 255", "0 1 0 51", "0 0 1 0"}).colours,
            (Colours{{255, 0, 0, 255}, {0, 255, 0, 51}, {0, 0, 255, 0}}));
  EXPECT_EQ(validation_error(rgb("float"), "0.5 1.5 1"), "vertex 2: its green is 1.5, not from 0 to 1")
      << "light of high dynamic range";
  EXPECT_EQ(validation_error(rgb("float"), "256 0 0"), "vertex 2: its red is 256, not from 0 to 1");
}

TEST(PlyPaint, TakesTheNamesOfOlderPrograms) {
  EXPECT_EQ(
      paint_of("property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n",
               {"255 0 51", "0 255 0", "1 2 3"})
          .colours,
      (Colours{{255, 0, 51, 255}, {0, 255, 0, 255}, {1, 2, 3, 255}}));
}

TEST(PlyPaint, IsEmptyWhereNothingWholeIsPainted) {
  EXPECT_TRUE(paint_of("", {"", "", ""}).empty());
  EXPECT_TRUE(paint_of("property uchar red\nproperty uchar alpha\n", {"1 2", "3 4", "5 6"}).empty());
  EXPECT_TRUE(paint_of("property list uchar float mask\n", {"0", "1 7", "0"}).empty());
}

TEST(PlyPaint, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(validation_error(rgb("uchar"), "0 256 0"), "vertex 2: its green is 256, not from 0 to 255");
  EXPECT_EQ(validation_error(rgb("float"), "0 0 nan"), "vertex 2: its blue is nan, not from 0 to 1");
  EXPECT_EQ(validation_error(rgb("float"), "inf 0 0"), "vertex 2: its red is inf, not from 0 to 1");
  const std::string mask = "property uchar a\nproperty uchar b\nproperty float mask\n";
  EXPECT_EQ(validation_error(mask, "0 0 1.5"), "vertex 2: its mask is 1.5, not from 0 to 1");
  EXPECT_EQ(validation_error(mask, "0 0 -0.1"), "vertex 2: its mask is -0.1, not from 0 to 1");
  EXPECT_EQ(validation_error(mask, "0 0 1"), "no error");
}

}  // namespace
}  // namespace burin
