#include <burin/stamp/float_image.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "picture_file.h"
#include "run_command.h"

namespace burin::test {
namespace {

using nlohmann::json;

constexpr const char* rock = "stamps/Rock035_height_1024_half_zip.exr";

TEST(StampCommand, SaysWhatAStampIs) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_PeriodicPattern.exr");
  const json stamp = burin_json({"stamp", path.string()});
  EXPECT_EQ(stamp["width"], 517);
  EXPECT_EQ(stamp["height"], 517);
  ASSERT_EQ(stamp["channels"].size(), 3u);
  EXPECT_EQ(stamp["channels"][1]["name"], "G");
  EXPECT_NEAR(stamp["channels"][1]["range"][0], 0.0100021, 1e-6);
  EXPECT_EQ(stamp["texels"], "half");
  EXPECT_EQ(stamp["format"], "openexr");
  EXPECT_EQ(stamp["compression"], "zip");
  EXPECT_EQ(stamp["tile"], json({64, 64}));
  EXPECT_EQ(stamp["mip_levels"], 10);
  EXPECT_EQ(stamp["wrap_of_file"], json({"periodic", "periodic"}));
  EXPECT_NEAR(stamp["seam"]["x_beside"], 0.99, 0.005);
  EXPECT_EQ(stamp["seam"]["verdict"], "tiles");
}

TEST(StampCommand, NamesAMissingModuleOfImages) {
  const CommandFolder folder;
  write_exr(folder.path("a.exr"), {1, 1, {"Y"}, {1}});
  std::filesystem::copy_file(BURIN_COMMAND, folder.path("burin"));
  const ProcessResult result = run_process({folder.path("burin"), "stamp", folder.path("a.exr")}, {});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
  EXPECT_NE(result.err.find("lib/burin/burin-images.so: cannot be loaded to read or write an image"),
            std::string::npos)
      << result.err;
}

/// Everything but one of the stamps loads; that one is a test of its own.
TEST(StampCommand, LoadsEveryRealStampAndJudgesItsSeam) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  int stamps = 0, not_tiling = 0, padded = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path.parent_path())) {
    if (entry.path().filename() == "oexr_BrightRingsNanInf.exr") continue;
    SCOPED_TRACE(entry.path());
    const json stamp = burin_json({"stamp", entry.path().string()});
    for (const json& channel : stamp["channels"]) {
      EXPECT_LE(channel["range"][0], channel["range"][1]);
      EXPECT_LT(std::abs(channel["range"][1].get<double>()), 20);
    }
    const std::string name = entry.path().filename().string(), verdict = stamp["seam"]["verdict"];
    const bool no_tile = name == "t3d_terrain3.exr" || name == "oexr_GrayRampsDiagonal.exr";
    EXPECT_EQ(verdict == "does not tile", no_tile);
    ++stamps;
    not_tiling += verdict == "does not tile";
    padded += verdict == "padded";
    if (!no_tile) continue;
    const std::string text = burin_output({"stamp", entry.path().string()});
    EXPECT_NE(text.find(": does not tile"), text.npos) << text;
  }
  EXPECT_EQ(stamps, 17);
  EXPECT_EQ(not_tiling, 2);
  EXPECT_EQ(padded, 8);
}

TEST(StampCommand, RefusesTexelsThatAreNotFiniteUnlessToldToCleanThem) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/oexr_BrightRingsNanInf.exr");
  const ProcessResult refused = burin({"stamp", path.string()});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(refused.err,
            "burin: " + path.string() + ":channel R, x 320, y 320: the texel is not finite (nan)\n");
  const ProcessResult cleaned = burin({"stamp", path.string(), "--clean", "--json"});
  EXPECT_EQ(cleaned.exit_code, 0);
  EXPECT_EQ(cleaned.err, "burin: warning: " + path.string() +
                             ": filled 18 values that are not finite from their neighbours\n");
  const json stamp = json::parse(cleaned.out);
  EXPECT_EQ(stamp["not_finite"], 18);
  EXPECT_EQ(stamp["channels"][0]["range"][1], 1025);
}

TEST(StampCommand, TakesLayersAndChannelsAndSaysWhatItLeaves) {
  const CommandFolder folder;
  const std::string path = folder.path("layers.exr");
  write_exr(path, {2, 1, {"a.Y", "b\x1b[2J.Y"}, {1, 2, 3, 4}});
  const json stamp = burin_json({"stamp", path, "--layer", "a"});
  EXPECT_EQ(stamp["channels"][0]["name"], "a.Y");
  EXPECT_EQ(stamp["channels"][0]["range"], json({1, 3}));
  EXPECT_EQ(stamp["unused_channels"].size(), 1u);
  const std::string text = burin_output({"stamp", path, "--channel", "a.Y"});
  EXPECT_NE(text.find("  not used: b\\x1b[2J.Y\n"), text.npos) << text;
  const ProcessResult refused = burin({"stamp", path});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err, "burin: " + path +
                             ": holds several layers, of which one must be chosen by its name: 'a', "
                             "'b\\x1b[2J'\n");
}

TEST(StampCommand, DrawsNineStampsAsTheyWrap) {
  BURIN_SHARED_DATA_OR_SKIP(path, "stamps/t3d_ring1.exr");
  const CommandFolder folder;
  const std::string png = folder.path("ring.png");
  burin_output({"stamp", path.string(), "--preview", png});
  const Picture picture = read_png(png);
  ASSERT_EQ(picture.width, 300);
  ASSERT_EQ(picture.height, 300);
  int white = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const Rgb middle = pixel(picture, 100 + x, 100 + y);
      ASSERT_EQ(middle, pixel(picture, x, 200 + y));
      white += middle[0] == 255;
    }
  EXPECT_GT(white, 100);
  burin_output({"stamp", path.string(), "--preview", png, "--wrap", "periodic,black"});
  const Picture row = read_png(png);
  for (int x = 0; x < 300; ++x) ASSERT_EQ(pixel(row, x, 50), (Rgb{0, 0, 0}));
  for (int x = 0; x < 300; ++x) ASSERT_EQ(pixel(row, x, 150), pixel(picture, x, 150));
}

TEST(StampCommand, DrawsLargeStampsSmaller) {
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  const CommandFolder folder;
  burin_output({"stamp", path.string(), "--preview", folder.path("rock.png")});
  const Picture picture = read_png(folder.path("rock.png"));
  EXPECT_EQ(picture.width, 1536);
  const auto [least, greatest] = std::ranges::minmax(picture.rgb);
  EXPECT_LT(least, 20);
  EXPECT_GT(greatest, 235);
}

TEST(StampCommand, RefusesBadInputInOneLine) {
  const CommandFolder folder;
  const std::string text = folder.write("text.exr", "this is no image"),
                    empty = folder.write("empty.png", "");
  BURIN_SHARED_DATA_OR_SKIP(path, rock);
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{text},
                                             {empty},
                                             {folder.path("missing.exr")},
                                             {folder.path("")},
                                             {path.string(), "--wrap", "round"},
                                             {path.string(), "--wrap", "periodic,"},
                                             {path.string(), "--preview", folder.path("missing/a.png")},
                                             {}}) {
    std::vector<std::string> command = {"stamp"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = burin(command);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

}  // namespace
}  // namespace burin::test
