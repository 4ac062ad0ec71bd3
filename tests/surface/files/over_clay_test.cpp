#include <burin/base/file.h>
#include <burin/base/srgb.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

/// Red over clay, 0.56, 0.41 and 0.32 of linear light, worked out by hand: a half, 128 of 255, a tenth, none.
const std::vector<PaintBytes> inks = {{255, 0, 0, 255}, {255, 0, 0, 128}, {255, 0, 0, 26}, {255, 0, 0, 0}};
const std::vector<PaintBytes> looks = {
    {255, 0, 0, 255}, {229, 125, 111, 255}, {204, 163, 146, 255}, {197, 172, 153, 255}};

TEST(OverClay, BlendsInLinearLight) {
  for (std::size_t i = 0; i < inks.size(); ++i) EXPECT_EQ(bytes_over_clay(inks[i]), looks[i]) << i;
  for (int channel = 0; channel < 256; ++channel) {
    const auto byte = static_cast<std::uint8_t>(channel);
    const Vec3f light = over_clay({byte, byte, byte, 255});
    EXPECT_EQ(to_srgb(light.x()), byte);
  }
}

TEST(OverClay, KnowsWhatWasPaintedSince) {
  std::vector<PaintBytes> shown = looks;
  shown[1][0] += 1;
  shown[2] = {9, 9, 9, 255};
  const std::vector<PaintBytes> colours = ink_unless_painted_over(shown, inks);
  EXPECT_EQ(colours[0], inks[0]);
  EXPECT_EQ(colours[1], inks[1]);
  EXPECT_EQ(colours[2], shown[2]);
  EXPECT_EQ(colours[3], inks[3]);
}

class SavedInk : public testing::Test {
 protected:
  /// The beginning of a PLY file, or the document of a GLB file.
  std::string saved(const std::string& name, const VertexPaint& paint) const {
    write_mesh(folder.path() / name, mesh, paint);
    const std::string bytes = read_file(folder.path() / name);
    return name.ends_with(".ply") ? bytes.substr(0, bytes.find("end_header"))
                                  : bytes.substr(20, bytes.find("BIN") - 24);
  }

  test::TemporaryFolder folder;
  TriangleMesh mesh = test::torus(20, 13);
};

TEST_F(SavedInk, ComesBackBitForBit) {
  VertexPaint paint;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    paint.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(7 * i), 200,
                             static_cast<std::uint8_t>(i < 256 ? i : 0)});
  for (const char* name : {"a.ply", "a.glb"}) {
    EXPECT_NE(saved(name, paint).find(std::string(name) == "a.ply" ? "ink_alpha" : "_INK"),
              std::string::npos);
    EXPECT_EQ(read_mesh(folder.path() / name).paint.colours, paint.colours) << name;
  }
}

TEST_F(SavedInk, IsNotThereWhereColoursCoverTheClay) {
  VertexPaint paint;
  paint.colours.assign(mesh.positions.size(), {1, 2, 3, 255});
  EXPECT_EQ(saved("a.ply", paint).find("ink"), std::string::npos);
  EXPECT_EQ(saved("a.ply", paint).find("alpha"), std::string::npos);
  EXPECT_EQ(saved("a.glb", paint).find("_INK"), std::string::npos);
  for (const char* name : {"a.ply", "a.glb"})
    EXPECT_EQ(read_mesh(folder.path() / name).paint.colours, paint.colours) << name;
}

TEST_F(SavedInk, IsWhatItLooksLikeForOthers) {
  VertexPaint paint;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) paint.colours.push_back(inks[i % inks.size()]);
  saved("a.off", paint);
  const std::vector<PaintBytes> shown = read_mesh(folder.path() / "a.off").paint.colours;
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_EQ(shown[i], looks[i % looks.size()]) << i;
}

TEST_F(SavedInk, IsReadAsCoverageInAlphaFromOldFiles) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 1 2 3 0\n1 0 0 4 5 6 128\n0 1 0 7 8 9 "
      "255\n3 "
      "0 1 2\n";
  write_file_whole(folder.path() / "old.ply", [&](std::ostream& out) { out << text; });
  EXPECT_EQ(read_mesh(folder.path() / "old.ply").paint.colours,
            (std::vector<PaintBytes>{{1, 2, 3, 0}, {4, 5, 6, 128}, {7, 8, 9, 255}}));
}

TEST_F(SavedInk, GivesWayToColoursThatAnotherProgramPainted) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar ink_red\nproperty uchar "
      "ink_green\nproperty uchar ink_blue\nproperty uchar ink_alpha\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 229 125 111 255 0 0 128\n"
      "1 0 0 30 40 50 255 0 0 128\n0 1 0 197 172 153 9 9 9 0\n3 0 1 2\n";
  write_file_whole(folder.path() / "other.ply", [&](std::ostream& out) { out << text; });
  const PolygonMesh back = read_mesh(folder.path() / "other.ply");
  EXPECT_EQ(back.paint.colours, (std::vector<PaintBytes>{{255, 0, 0, 128}, {30, 40, 50, 255}, {9, 9, 9, 0}}));
  EXPECT_EQ(back.not_used, "");
}

}  // namespace
}  // namespace burin
