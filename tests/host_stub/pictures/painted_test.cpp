#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_stub/picture_file.h"
#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

using nlohmann::json;

constexpr const char* equator = "\"brush\":\"org.burin.groove\",\"radius\":0.2";

/// A unit sphere with opaque blue, protected dashes along its equator.
struct Dashes {
  CommandFolder folder;
  TriangleMesh mesh = shuffled(sphere(5, 0.2, 3), 4);
  std::string bare = folder.write("sphere.obj", obj_text(mesh)), painted = folder.path("painted.ply");
  std::string stroke = folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, equator));

  std::vector<std::string> dashed(const std::vector<std::string>& options) const {
    std::vector<std::string> all = {
        "replay",  stroke,      "--mesh",  bare,      "--brush", "org.burin.dashed-line",
        "--param", "width=0.8", "--param", "height=0"};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }

  PolygonMesh paint() const {
    burin_output(dashed({"--param", "colour=0.05,0.2,0.5,1", "--param", "mask=1", "--save-mesh", painted}));
    return read_mesh(painted);
  }

  PolygonMesh grooved(const std::string& path) const {
    burin_output({"replay", stroke, "--mesh", path, "--save-mesh", folder.path("out.ply")});
    return read_mesh(folder.path("out.ply"));
  }

  Picture render(const std::string& path) const {
    burin_output({"render", "--mesh", path, "--png", folder.path("a.png"), "--view", "0,0,-1", "--width",
                  "160", "--height", "120"});
    return read_png(folder.path("a.png"));
  }
};

int count_blue(const Picture& picture) {
  int count = 0;
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column) {
      const Rgb rgb = pixel(picture, column, row);
      count += rgb[2] > rgb[0] + 20 ? 1 : 0;
    }
  return count;
}

TEST(PaintedMesh, IsSavedAndRenderedWithItsColours) {
  const Dashes dashes;
  const PolygonMesh saved = dashes.paint();
  ASSERT_EQ(saved.paint.colours.size(), dashes.mesh.positions.size());
  const std::array<std::uint8_t, 4> ink = {63, 124, 188, 255};  // 0.05, 0.2, 0.5 in sRGB
  EXPECT_GT(std::ranges::count(saved.paint.colours, ink), 100);
  EXPECT_GT(std::ranges::count(saved.paint.masks, 0.0f), 100);
  for (std::size_t i = 0; i < saved.positions.size(); ++i) {
    EXPECT_EQ(saved.positions[i], dashes.mesh.positions[i]);
    if (std::abs(saved.positions[i].y()) < 0.2f) continue;
    ASSERT_EQ(saved.paint.colours[i][3], 0);
    ASSERT_EQ(saved.paint.masks[i], 1);
  }
  EXPECT_EQ(count_blue(dashes.render(dashes.bare)), 0);
  EXPECT_GT(count_blue(dashes.render(dashes.painted)), 100);
}

TEST(PaintedMesh, ProtectsWhatItsMaskSays) {
  const Dashes dashes;
  const PolygonMesh before = dashes.paint(), after = dashes.grooved(dashes.painted),
                    free = dashes.grooved(dashes.bare);
  EXPECT_TRUE(free.paint.empty());
  int kept = 0, moved = 0;
  for (std::size_t i = 0; i < before.positions.size(); ++i) {
    const bool moves = free.positions[i] != before.positions[i];
    if (moves && before.paint.masks[i] == 0) {
      EXPECT_EQ(after.positions[i], before.positions[i]);
      ++kept;
    } else if (moves && before.paint.masks[i] == 1) {
      EXPECT_EQ(after.positions[i], free.positions[i]);
      ++moved;
    }
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(moved, 100);
  EXPECT_EQ(after.paint.colours, before.paint.colours);
  EXPECT_EQ(after.paint.masks, before.paint.masks);
}

TEST(PaintedMesh, IsBenchedAsItIsReplayed) {
  const Dashes dashes;
  dashes.paint();
  const json suite = {
      {"burin_suite", 1},
      {"name", "painted"},
      {"cases", {{{"name", "a"}, {"mesh", "painted.ply"}, {"strokes", {"a.stroke"}}, {"repeat", 2}}}}};
  const json benched = burin_json({"bench", dashes.folder.write("suite.json", suite.dump())});
  EXPECT_EQ(benched["cases"][0]["hash"],
            burin_json({"replay", dashes.stroke, "--mesh", dashes.painted})["result_hash"]);
}

TEST(PaintedMesh, IsInTheReportBeforeTheStrokesToo) {
  const Dashes dashes;
  dashes.paint();
  burin_output({"replay", dashes.stroke, "--mesh", dashes.painted, "--report", dashes.folder.path("report"),
                "--view", "0,0,-1", "--width", "200", "--height", "150"});
  EXPECT_GT(count_blue(read_png(dashes.folder.path("report/before.png"))), 100);
  EXPECT_GT(count_blue(read_png(dashes.folder.path("report/after.png"))), 100);
}

TEST(PaintedMesh, LosesItsPaintWhereItIsRefinedAndSaysSo) {
  const Dashes dashes;
  dashes.paint();
  const ProcessResult result = burin({"replay", dashes.stroke, "--mesh", dashes.painted, "--subdivide", "1",
                                      "--save-mesh", dashes.folder.path("out.ply")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "burin: warning: " + dashes.painted +
                            ": colours and masks are left behind: they are kept on meshes that are not "
                            "refined\n");
  EXPECT_TRUE(read_mesh(dashes.folder.path("out.ply")).paint.empty());
}

TEST(PaintedMesh, WarnsOfPaintOnACoarserLevel) {
  const Dashes dashes;
  const std::vector<std::string> levels = {"--subdivide", "1", "--sculpt-level", "0"};
  std::vector<std::string> arguments = dashes.dashed({"--param", "mask=1"});
  arguments.insert(arguments.end(), levels.begin(), levels.end());
  const ProcessResult lost = burin(arguments);
  EXPECT_EQ(lost.exit_code, 0);
  EXPECT_EQ(lost.err.rfind("burin: warning: --sculpt-level ", 0), 0u) << lost.err;
  arguments = dashes.dashed(levels);
  burin_output(arguments);
}

TEST(PaintedMesh, HoldsNoColoursWhereOnlyReliefWasDrawn) {
  const Dashes dashes;
  burin_output(dashes.dashed({"--param", "height=0.1", "--save-mesh", dashes.painted}));
  EXPECT_TRUE(read_mesh(dashes.painted).paint.empty());
}

}  // namespace
}  // namespace burin::test
