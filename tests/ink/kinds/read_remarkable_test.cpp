#include "ink/kinds/bytes.h"
#include "ink/pen_files.h"

namespace burin {
namespace {

using test::Bytes;
using test::PenFileFolder;
using test::places;

std::string head(char version) {
  std::string text = "reMarkable .lines file, version=";
  text += version;
  text.resize(43, ' ');
  return text;
}

Bytes& add_point(Bytes& bytes, float x, float y) {
  return bytes.add(x).add(y).add(0.F).add(1.F).add(2.F).add(0.5F);
}

/// Version 5: an empty layer, and one with an eraser's line that tells `told` points and has one.
std::string layers(std::uint32_t told) {
  Bytes bytes;
  bytes.add_text(head('5')).add(2U).add(0U).add(1U);
  bytes.add(6U).add(0U).add(7U).add(2.F).add(9U).add(told);
  return add_point(bytes, 1, 2).text();
}

/// An id of version 6 with its tag.
Bytes& add_id(Bytes& bytes, std::uint64_t index, std::uint64_t number) {
  return bytes.add_varint(index << 4 | 15).add(std::uint8_t{1}).add_varint(number);
}

std::string line_block(std::uint64_t own, std::uint64_t left, const std::string& line) {
  Bytes bytes;
  add_id(bytes, 1, 99);
  add_id(bytes, 2, own);
  add_id(bytes, 3, left);
  add_id(bytes, 4, 0);
  bytes.add_varint(5 << 4 | 4).add(0U);
  if (!line.empty())
    bytes.add_varint(6 << 4 | 12).add(static_cast<std::uint32_t>(line.size())).add_text(line);
  const std::string content = bytes.text();
  Bytes block;
  block.add(static_cast<std::uint32_t>(content.size()))
      .add_text(std::string_view("\0\1\2\5", 4))
      .add_text(content);
  return block.text();
}

/// The value of a line with one small point.
std::string line_at(float x) {
  Bytes bytes;
  bytes.add(std::uint8_t{3}).add_varint(1 << 4 | 4).add(15U).add_varint(5 << 4 | 12).add(14U);
  bytes.add(x)
      .add(2.F)
      .add(std::uint16_t{0})
      .add(std::uint16_t{6})
      .add(std::uint8_t{0})
      .add(std::uint8_t{51});
  return bytes.text();
}

TEST(ReadRemarkable, HasLayersOfLines) {
  const PenFile file = PenFileFolder().read(layers(1));
  EXPECT_EQ(file.kind, "remarkable");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(file.strokes[0].layer, 2u);
  EXPECT_TRUE(file.strokes[0].eraser);
  EXPECT_EQ(places(file.strokes[0]), "1 2");
  EXPECT_EQ(file.strokes[0].fields, PenFields{.pressure = true});
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.5F);
}

TEST(ReadRemarkable, OrdersLinesByTheirNeighbours) {
  const PenFile file = PenFileFolder().read(head('6') + line_block(10, 12, line_at(3)) +
                                            line_block(12, 11, "") + line_block(11, 0, line_at(-4)));
  ASSERT_EQ(file.strokes.size(), 2u) << "one was deleted";
  EXPECT_EQ(places(file.strokes[0]), "-4 2");
  EXPECT_EQ(places(file.strokes[1]), "3 2");
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 51 / 255.F);
  EXPECT_EQ(file.strokes[0].widths, std::vector<float>{1.5F});
}

TEST(ReadRemarkable, NamesTheByteOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(layers(0x80000000U)), "byte 79: 51539607552 bytes are told, 24 follow");
  EXPECT_EQ(folder.complaint(head('9')),
            "byte 43: lines of a version that is not known; known are 3, 5 and 6");
  EXPECT_EQ(folder.complaint(head('5') + std::string("\xff\xff\xff\x7f", 4)),
            "byte 47: 2147483647 items are told, 0 bytes follow");
}

}  // namespace
}  // namespace burin
