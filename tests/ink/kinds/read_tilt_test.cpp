#include "ink/kinds/bytes.h"
#include "ink/pen_files.h"

namespace burin {
namespace {

using test::Bytes;
using test::PenFileFolder;

/// A sketch with one stroke that tells `told` points and has one.
std::string sketch(std::uint32_t told) {
  Bytes bytes;
  bytes.add(0xc576a5cdU).add(5).add(0).add(4U).add_text("more").add(1);
  bytes.add(0).add(1.F).add(0.F).add(0.F).add(1.F).add(0.5F);            // brush, colour, size
  bytes.add(0x10003U).add(3U).add(0U).add(2.F).add(3U).add_text("xyz");  // masks, flags, scale, an extension
  bytes.add(told).add(1.F).add(2.F).add(3.F).add(0.F).add(0.F).add(0.F).add(1.F).add(0.25F).add(1500U);
  return bytes.text();
}

TEST(ReadTilt, HasPointsInSpace) {
  const PenFile file = PenFileFolder().read(sketch(1));
  EXPECT_EQ(file.kind, "tilt");
  ASSERT_EQ(file.strokes.size(), 1u);
  const PenStroke& stroke = file.strokes[0];
  EXPECT_TRUE(stroke.has_z);
  EXPECT_EQ(stroke.fields, (PenFields{.time = true, .pressure = true}));
  ASSERT_EQ(stroke.samples.size(), 1u);
  EXPECT_EQ(stroke.samples[0].position, Vec3d(1, 2, -3)) << "z towards the viewer";
  EXPECT_EQ(stroke.samples[0].time, 1.5);
  EXPECT_EQ(stroke.samples[0].pen.pressure, 0.25F);
  EXPECT_EQ(stroke.widths, std::vector<float>{1}) << "size by scale";
}

TEST(ReadTilt, HasTheLayerOfOpenBrush) {
  Bytes bytes;
  bytes.add(0xc576a5cdU).add(6).add(0).add(0U).add(2);
  for (const std::uint32_t layer : {2U, 0U}) {
    bytes.add(0).add(1.F).add(0.F).add(0.F).add(1.F).add(0.5F);
    bytes.add(0x1fU).add(0U);                                  // all short words; points without more
    bytes.add(0U).add(2.F).add(7U).add(8U).add(layer).add(1);  // flags, scale, group, seed
    for (int i = 0; i < 7; ++i) bytes.add(1.F);
  }
  const PenFile file = PenFileFolder().read(bytes.text());
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(file.strokes[0].layer, 3u);
  EXPECT_EQ(file.strokes[1].layer, 1u);
  EXPECT_EQ(file.strokes[0].fields, PenFields());
  EXPECT_EQ(file.strokes[0].widths, std::vector<float>{1});
}

TEST(ReadTilt, ReadsASketchThatIsAFolder) {
  const test::TemporaryFolder folder;
  write_file_whole(folder.path() / "data.sketch", [](std::ostream& out) { out << sketch(1); });
  EXPECT_EQ(read_pen_file(folder.path()).strokes.size(), 1u);
  std::filesystem::remove(folder.path() / "data.sketch");
  EXPECT_THROW(read_pen_file(folder.path()), FileError);
}

TEST(ReadTilt, ReadsZipsBehindAHeadOfAnySizeOrNone) {
  const std::string zip = test::stored_zip({{"metadata.json", "{}"}, {"data.sketch", sketch(1)}});
  const auto head = [](std::uint16_t size) {
    return Bytes()
        .add_text("tilT")
        .add(size)
        .add(std::uint16_t{1})
        .add_text(std::string(size - 8, '\0'))
        .text();
  };
  for (const std::string& text : {head(16) + zip, head(24) + zip, zip,
                                  test::stored_zip({{"Untitled_1.tilt/data.sketch", sketch(1)}})}) {
    const PenFile file = PenFileFolder().read(text);
    EXPECT_EQ(file.kind, "tilt");
    EXPECT_EQ(file.strokes.size(), 1u);
  }
}

TEST(ReadTilt, NamesTheByteOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(sketch(0x80000000U)), "byte 75: 2147483648 items are told, 36 bytes follow");
  EXPECT_EQ(folder.complaint(sketch(1) + "!"), "byte 111: bytes follow the last stroke");
  EXPECT_EQ(folder.complaint(std::string("tilT\x10\0\1\0\0\0\0\0\0\0\0\0", 16)),
            " cannot be unpacked: Unrecognized archive format");
}

}  // namespace
}  // namespace burin
