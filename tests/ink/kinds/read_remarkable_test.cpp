#include <burin/ink/pen_file_facts.h>

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

std::string id(std::uint64_t index, std::uint64_t number) {
  Bytes bytes;
  return add_id(bytes, index, number).text();
}

/// A part of version 6 with its tag.
std::string part(std::uint64_t index, const std::string& content) {
  Bytes bytes;
  bytes.add_varint(index << 4 | 12).add(static_cast<std::uint32_t>(content.size()));
  return bytes.add_text(content).text();
}

std::string block(char type, const std::string& content) {
  Bytes bytes;
  bytes.add(static_cast<std::uint32_t>(content.size())).add_text(std::string_view("\0\1\2", 3));
  return bytes.add(type).add_text(content).text();
}

std::string item_block(char type, const std::string& parent, std::uint64_t own, std::uint64_t left,
                       const std::string& content) {
  Bytes bytes;
  bytes.add_text(parent + id(2, own) + id(3, left) + id(4, 0)).add_varint(5 << 4 | 4).add(0U);
  return block(type, bytes.text() + (content.empty() ? "" : part(6, content)));
}

/// A line of a layer or group, or what a deleted one left.
std::string line_block(std::uint64_t own, std::uint64_t left, const std::string& line,
                       std::uint64_t layer = 99) {
  return item_block(5, id(1, layer), own, left, line);
}

/// An item that puts a group into another one.
std::string group_item(std::uint64_t own, std::uint64_t left, std::uint64_t group,
                       const std::string& parent) {
  return item_block(4, parent, own, left, "\2" + id(2, group));
}

/// The root of a page, whose author is 0.
const std::string root("\x1f\0\1", 3);

/// A group whose coordinates begin at x, beside a character of the typed text.
std::string anchored_group(std::uint64_t group, std::uint64_t character, float x) {
  Bytes real;
  real.add_varint(2 << 4 | 4).add(x);
  const std::string set_by = id(1, 500);
  return block(2, id(1, group) + part(7, set_by + id(2, character)) + part(10, set_by + real.text()));
}

/// A piece of typed text, whose characters have the ids from `own` on.
std::string piece(std::uint64_t own, std::uint64_t left, const std::string& text) {
  Bytes characters;
  characters.add_varint(text.size()).add(std::uint8_t{1}).add_text(text);
  return part(0, id(2, own) + id(3, left) + id(4, 0) + part(6, characters.text()));
}

/// The typed text of so many pieces at y = 200, with a bullet behind the line end 203.
std::string text_block(char count, const std::string& pieces) {
  Bytes style, place;
  style.add(std::uint8_t{1}).add_varint(203);
  const std::string styles = "\1" + style.text() + id(1, 7) + part(2, "\x11\x04");
  place.add(-400.0).add(200.0);
  return block(7, id(1, 0) + part(2, part(1, part(1, count + pieces)) + part(2, part(1, styles))) +
                      part(3, place.text()));
}

std::string text_block(const std::string& first, const std::string& second) {
  return text_block(2, first + second);
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
  EXPECT_TRUE(file.strokes[0].drawn_by.eraser);
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

TEST(ReadRemarkable, FollowsLayersFromTheRoot) {
  const PenFile file =
      PenFileFolder().read(head('6') + line_block(10, 0, line_at(1), 30) + line_block(11, 0, line_at(2), 31) +
                           line_block(12, 0, line_at(3), 32) + group_item(20, 21, 30, root) +
                           group_item(21, 0, 31, root) + group_item(22, 0, 32, id(1, 31)));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "2 2");
  EXPECT_EQ(file.strokes[0].layer, 1u);
  EXPECT_EQ(places(file.strokes[1]), "3 2") << "of a group within the layer";
  EXPECT_EQ(file.strokes[1].layer, 1u);
  EXPECT_EQ(places(file.strokes[2]), "1 2");
  EXPECT_EQ(file.strokes[2].layer, 2u);
}

TEST(ReadRemarkable, PutsGroupsBesideTheirText) {
  // "ab", a bullet "c", and "d", whose piece comes first.
  const std::string text = text_block(piece(300, 205, "d"), piece(201, 0, "ab\nc\n"));
  const auto place_beside = [&](std::uint64_t character) {
    return places(PenFileFolder()
                      .read(head('6') + text + anchored_group(32, character, -464) +
                            group_item(21, 0, 31, root) + group_item(22, 0, 32, id(1, 31)) +
                            line_block(12, 0, line_at(3), 32))
                      .strokes.at(0));
  };
  EXPECT_EQ(place_beside(202), "-461 184") << "88 above the text, a line of 70 below that";
  EXPECT_EQ(place_beside(203), "-461 184") << "the end of the line";
  EXPECT_EQ(place_beside(204), "-461 219") << "35 lower";
  EXPECT_EQ(place_beside(300), "-461 289");
  EXPECT_EQ(place_beside(999), "-461 2") << "a character that is not there";
}

TEST(ReadRemarkable, TellsWhichPlacesAreEstimates) {
  const PenFile file =
      PenFileFolder().read(head('6') + text_block(1, piece(201, 0, "ab\n")) + anchored_group(32, 202, -464) +
                           group_item(21, 0, 31, root) + group_item(22, 0, 32, id(1, 31)) +
                           group_item(23, 0, 33, id(1, 32)) + line_block(11, 0, line_at(1), 31) +
                           line_block(12, 0, line_at(3), 32) + line_block(13, 0, line_at(5), 33));
  ASSERT_EQ(file.strokes.size(), 3u);
  std::string estimated;
  for (const PenStroke& stroke : file.strokes) {
    estimated += places(stroke) + (stroke.estimated_y ? " estimated; " : " exact; ");
    EXPECT_EQ(stroke.samples[0].pen.pressure, 51 / 255.F) << "nothing else is";
    EXPECT_EQ(stroke.widths, std::vector<float>{1.5F});
  }
  EXPECT_NE(estimated.find("-461 184 estimated; "), estimated.npos) << estimated;
  EXPECT_NE(estimated.find("-459 184 estimated; "), estimated.npos) << "in a group in it: " << estimated;
  EXPECT_NE(estimated.find("1 2 exact; "), estimated.npos) << estimated;
  EXPECT_EQ(facts_of(file).estimated_y, 2u);
}

/// A piece whose characters were deleted.
std::string deleted_piece(std::uint64_t own, std::uint64_t left, std::uint32_t count) {
  Bytes bytes;
  bytes.add_varint(5 << 4 | 4).add(count);
  return part(0, id(2, own) + id(3, left) + id(4, 0) + bytes.text());
}

/// Where a line is that is beside the character in the text blocks.
std::string place_beside(std::uint64_t character, const std::string& text) {
  return places(PenFileFolder()
                    .read(head('6') + text + anchored_group(32, character, 0) + group_item(21, 0, 31, root) +
                          group_item(22, 0, 32, id(1, 31)) + line_block(12, 0, line_at(3), 32))
                    .strokes.at(0));
}

TEST(ReadRemarkable, ReadsTheFirstTextOfAPage) {
  const std::string first = text_block(piece(201, 0, "ab\n"), piece(300, 203, "c"));
  EXPECT_EQ(place_beside(300, first), "3 219");
  EXPECT_EQ(place_beside(300, first + text_block(piece(300, 0, "c"), piece(201, 300, "ab"))), "3 219");
}

TEST(ReadRemarkable, CountsNoMoreDeletedCharactersThanAreOfUse) {
  const std::string text = text_block(deleted_piece(1000, 0, 4'000'000'000), piece(999, 0, "\n"));
  EXPECT_EQ(place_beside(10'999, text), "3 254") << "behind the line end";
  EXPECT_EQ(place_beside(11'000, text), "3 2") << "a character that is not there";
}

TEST(ReadRemarkable, LeavesOutCharactersBeyondAnyText) {
  std::string pieces;
  for (std::uint64_t i = 1; i <= 10; ++i) pieces += deleted_piece(20'000 * i, 0, 10'000);
  const std::string text = text_block(11, pieces + piece(400'000, 0, "a"));
  EXPECT_EQ(place_beside(209'999, text), "3 184");
  EXPECT_EQ(place_beside(400'000, text), "3 2") << "the character behind 100,000";
}

TEST(ReadRemarkable, RefusesEndlessGroups) {
  std::string groups = group_item(1000, 0, 1001, root);
  for (std::uint64_t group = 1001; group < 1110; ++group)
    groups += group_item(group + 1000, 0, group + 1, id(1, group));
  EXPECT_EQ(PenFileFolder().complaint(head('6') + groups),
            "byte " + std::to_string(43 + groups.size()) + ": groups within more than 100 others");
  const PenFile file =
      PenFileFolder().read(head('6') + group_item(20, 0, 31, id(1, 32)) + group_item(21, 0, 32, id(1, 31)) +
                           line_block(12, 0, line_at(3), 32));
  EXPECT_EQ(file.strokes.size(), 1u) << "within each other";
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
