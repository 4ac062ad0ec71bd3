// Tests EXR stamps: headers, layers and parts.
#include <burin/base/file.h>
#include <burin/stamp/files/stamp_file.h>
#include <gtest/gtest.h>

#include <cstring>

#include "stamp/files/stamp_files.h"

namespace burin::test {
namespace {

using namespace std::string_literals;

using ExrFiles = StampFiles;

/// OpenEXR would ask for gigabytes before it reads a texel.
TEST_F(ExrFiles, AsksForNoMoreThanAnExrHeaderMay) {
  OIIO::ImageSpec spec(1, 8, 1, OIIO::TypeFloat);
  spec.attribute("compression", "none");
  const auto with = [&](const std::string& member, std::size_t at, std::uint32_t number) {
    write_image(path("a.exr"), spec, std::vector<float>(256));
    std::string bytes = read_file(path("a.exr"));
    const std::size_t begin = bytes.find(member);
    EXPECT_NE(begin, bytes.npos) << member;
    std::memcpy(bytes.data() + begin + member.size() + 4 + at, &number, 4);
    write_file_whole(path("a.exr"), [&](std::ostream& out) { out << bytes; });
    return complaint(path("a.exr"));
  };
  const std::string window = "dataWindow\0box2i\0"s, tiles = "tiles\0tiledesc\0"s;
  EXPECT_EQ(with(window, 12, 7), "accepted");
  EXPECT_TRUE(with(window, 12, 2000000000).starts_with(": is too large: 1 x 2000000001 texels"));
  EXPECT_TRUE(with(window, 12, 100000000).starts_with(": asks for 400 MB of memory in "));
  EXPECT_EQ(with(window, 12, 15000000), ": is cut off: it tells of more chunks than it has room for");
  EXPECT_TRUE(with(window, 8, 1000000000).starts_with(": is too large: 1000000001 x 8 texels"));
  spec.attribute("compression", "piz");
  EXPECT_TRUE(with(window, 8, 999999).starts_with(": asks for 128 MB of memory in "));
  constexpr auto size_before = static_cast<std::size_t>(-4);
  for (const std::string& member : {"lineOrder\0lineOrder\0"s, "channels\0chlist\0"s})
    EXPECT_EQ(with(member, size_before, 24), ": is damaged: its header has an attribute of a wrong size");
  EXPECT_EQ(with("channels\0chlist\0"s, size_before, 2000000000), ": is damaged: its header has no end");
  spec = OIIO::ImageSpec(16, 16, 1, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 16;
  EXPECT_EQ(with(tiles, 0, 16), "accepted");
  EXPECT_TRUE(with(tiles, 0, 4000000000).starts_with(": is too large: 4000000000 x 16 texels"));
  const std::string whole = read_file(path("a.exr"));
  for (const std::size_t size : {7u, 40u, 100u}) {
    write_file_whole(path("cut.exr"), [&](std::ostream& out) { out << whole.substr(0, size); });
    EXPECT_EQ(complaint(path("cut.exr")), ": is damaged: its header has no end");
  }
}

TEST_F(ExrFiles, ReadsLayersAndChannelsOfExrByName) {
  OIIO::ImageSpec spec(1, 1, 7, OIIO::TypeFloat);
  spec.channelnames = {"disp.B", "disp.G", "disp.R", "mask.Y", "n.X", "n.Y", "n.Z"};
  const std::vector<float> values = {3, 2, 1, 4, 5, 6, 7};
  write_image(path("layers.exr"), spec, values);
  const auto texels = [&](const char* layer, const char* channel) {
    return read_stamp(path("layers.exr"), {.layer = layer, .channel = channel}).texels;
  };
  EXPECT_EQ(texels("disp", ""), (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(texels("mask", ""), (std::vector<float>{4}));
  EXPECT_EQ(texels("n", ""), (std::vector<float>{5, 6, 7}));
  EXPECT_EQ(texels("", "n.Z"), (std::vector<float>{7}));
  EXPECT_EQ(texels("disp", "G"), (std::vector<float>{2}));
  EXPECT_EQ(texels("", "n.Z,disp.R,mask.Y"), (std::vector<float>{7, 1, 4}));
  EXPECT_EQ(complaint(path("layers.exr")),
            ": holds several layers, of which one must be chosen by its name: 'disp', 'mask', 'n'");
}

TEST_F(ExrFiles, HasPartsOfExrAsLayers) {
  std::vector<OIIO::ImageSpec> parts(2, OIIO::ImageSpec(2, 1, 3, OIIO::TypeFloat));
  parts[1] = OIIO::ImageSpec(1, 1, 1, OIIO::TypeFloat);
  parts[1].full_width = 2;  // all parts have one display window
  parts[0].attribute("name", "disp");
  parts[1].attribute("name", "mask");
  const auto output = OIIO::ImageOutput::create("a.exr");
  const std::string file = path("parts.exr").string();
  const std::vector<float> values = {1, 2, 3, 4, 5, 6}, mask = {7}, shown = {7, 0};
  ASSERT_TRUE(output->open(file, 2, parts.data())) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
  ASSERT_TRUE(output->open(file, parts[1], OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, mask.data()));
  output->close();
  EXPECT_EQ(read_stamp(file, {.layer = "disp"}).texels, values);
  EXPECT_EQ(read_stamp(file, {.layer = "mask"}).texels, shown);
  EXPECT_EQ(complaint(file),
            ": holds several layers, of which one must be chosen by its name: 'disp', 'mask'");
}

}  // namespace
}  // namespace burin::test
