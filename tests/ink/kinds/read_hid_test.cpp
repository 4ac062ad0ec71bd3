#include <fmt/format.h>

#include <numbers>

#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

/// A pen of report 2: tip, barrel, eraser and in range, 4 bits of padding; X and Y of 12 bits in 1/100 cm
/// each 0..1000 for 0..2000; pressure of 16 bits; tilt in degrees. Report 3 is something else.
const std::string descriptor =
    "# a comment\nR: 105 05 0d 09 02 a1 01 85 02 09 20 a1 00 09 42 09 44 09 45 09 32 15 00 25 01 75 01 95 04 "
    "81 02 "
    "95 04 81 03 05 01 09 30 09 31 65 11 55 0e 35 00 46 e8 03 26 d0 07 75 0c 95 02 81 02 05 0d 09 30 65 00 "
    "55 00 "
    "45 00 26 ff 03 75 10 95 01 81 02 09 3d 09 3e 65 14 15 c0 25 3f 35 c0 45 3f 75 08 95 02 81 02 85 03 09 "
    "3b 81 "
    "02 c0 c0\nN: A Pen\nI: 3 056a 0357\n";

TEST(ReadHid, CutsReportsByTheDescriptor) {
  // x = 200, y = 400: 0x0c8 and 0x190 in 12 bits each.
  const PenFile file = PenFileFolder().read(descriptor +
                                            "E: 000000.000000 9 02 08 c8 00 19 00 00 0a f6\n"
                                            "E: 000000.005000 9 02 09 c8 00 19 ff 01 0a f6\n"
                                            "E: 000000.006000 2 03 50\n"
                                            "E: 000000.010000 9 02 0b 90 01 19 ff 03 00 00\n"
                                            "E: 000000.015000 9 02 0c 90 01 19 ff 03 00 00\n");
  EXPECT_EQ(file.device, "A Pen");
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.hovering, 1u);
  ASSERT_EQ(file.strokes.size(), 2u);
  // Logical 0..2000 mean 0..1000 times 10^-2 cm.
  EXPECT_EQ(places(file.strokes[0]), "10 20, 20 20");
  EXPECT_TRUE(file.strokes[1].drawn_by.eraser);
  const Sample& sample = file.strokes[0].samples[0];
  EXPECT_NEAR(sample.pen.pressure, 511 / 1023., 1e-6);
  EXPECT_NEAR(sample.pen.tilt_x, 10 * std::numbers::pi / 180, 1e-6);
  EXPECT_NEAR(sample.pen.tilt_y, -10 * std::numbers::pi / 180, 1e-6);
  EXPECT_DOUBLE_EQ(sample.time, 0.005);
  EXPECT_TRUE(file.strokes[0].fields.barrel);
  EXPECT_FALSE(sample.barrel);
  EXPECT_TRUE(file.strokes[0].samples[1].barrel) << "the second bit";
}

TEST(ReadHid, TakesTheTipOfAnInvertedPenForItsEraser) {
  const std::string inverted =
      "R: 35 05 0d 09 02 a1 01 09 42 09 3c 15 00 25 01 75 04 95 02 81 02 05 01 09 30 09 31 26 ff 00 75 08 "
      "95 02 81 02\n";
  const PenFile file = PenFileFolder().read(inverted + "E: 0 3 01 07 09\nE: 1 3 11 08 09\nE: 2 3 10 08 09\n");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_FALSE(file.strokes[0].drawn_by.eraser);
  EXPECT_TRUE(file.strokes[1].drawn_by.eraser);
  EXPECT_EQ(file.hovering, 1u);
}

TEST(ReadHid, TakesRadiansWhereTheDescriptorHasThem) {
  std::string in_radians = descriptor;
  in_radians.replace(in_radians.find("65 14"), 5, "65 12");
  const PenFile file = PenFileFolder().read(in_radians + "E: 0 9 02 09 c8 00 19 ff 01 02 ff\n");
  EXPECT_EQ(file.strokes.at(0).samples.at(0).pen.tilt_x, 2);
  EXPECT_EQ(file.strokes[0].samples[0].pen.tilt_y, -1);
}

TEST(ReadHid, PartsTouchesOfWhichEachReportHasOne) {
  // Report 4 of a screen: tip, id, x and y, a byte each.
  const PenFile file = PenFileFolder().read(
      "R: 41 05 0d 09 04 a1 01 85 04 09 22 a1 02 09 42 15 00 25 01 75 08 95 01 81 02 09 51 25 7f 81 02 05 01 "
      "09 30 "
      "09 31 95 02 81 02 c0\n"
      "E: 0 5 04 01 00 0a 14\nE: 0 5 04 01 01 64 14\nE: 0.01 5 04 01 00 0b 14\nE: 0.01 5 04 01 01 65 14\n"
      "E: 0.02 5 04 00 00 0b 14\nE: 0.02 5 04 01 01 66 14\n");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 11 20");
  EXPECT_EQ(places(file.strokes[1]), "100 20, 101 20, 102 20");
  EXPECT_EQ(file.strokes[1].drawn_by.tool, "touch");
}

TEST(ReadHid, HasThePressureOfTouches) {
  const PenFile file = PenFileFolder().read(
      "R: 48 05 0d 09 04 a1 01 85 04 09 22 a1 02 09 42 15 00 25 01 75 08 95 01 81 02 09 51 25 7f 81 02 09 30 "
      "26 ff 00 81 02 05 01 09 30 09 31 95 02 81 02 c0\n"
      "E: 0 6 04 01 00 33 0a 14\nE: 0.01 6 04 01 00 ff 0b 14\n");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 11 20");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_FLOAT_EQ(file.strokes[0].samples[0].pen.pressure, 0.2F);
}

/// The lines of a tablet that tells of two touches at a time: their number, then the id, tip switch, x and y
/// of each, in 1/40 mm. Its usages are those of Wacom's page of touch.
std::string touches(const std::vector<std::string>& reports) {
  const std::string touch =
      "09 22 a1 02 09 51 65 00 55 00 15 00 26 ff 00 75 08 95 01 81 02 09 42 25 01 75 01 81 02 95 07 81 03 0a "
      "30 01 "
      "65 11 55 0d 35 00 46 80 57 26 00 23 75 10 95 01 81 02 0a 31 01 46 d0 39 26 20 17 81 02 c0 ";
  const std::string bytes =
      "06 00 ff 09 05 a1 01 85 21 09 54 15 00 26 ff 00 75 08 95 01 81 02 " + touch + touch + "c0";
  std::string text = "R: " + std::to_string((bytes.size() + 1) / 3) + " " + bytes + "\nN: Touch\n";
  for (std::size_t i = 0; i < reports.size(); ++i)
    text += "E: " + std::to_string(i) + " 14 21 " + reports[i] + "\n";
  return text;
}

TEST(ReadHid, PartsTouchesByTheirIds) {
  const std::string none = " 00 00 00 00 00 00", first = " 00 01 90 01 20 03";
  const PenFile file = PenFileFolder().read(
      touches({"01" + first + none, "02 00 01 b8 01 20 03 03 01 a0 0f 90 01",
               "02" + none + " 03 01 c8 0f 90 01", "01 03 00 c8 0f 90 01" + none, "01" + first + none}));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 11 20");
  EXPECT_EQ(places(file.strokes[1]), "100 10, 101 10");
  EXPECT_EQ(places(file.strokes[2]), "10 20");
  EXPECT_EQ(file.strokes[0].drawn_by.tool, "touch");
  EXPECT_EQ(file.strokes[0].fields, PenFields{.time = true});
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.hovering, 1u);
}

TEST(ReadHid, CountsTouchesOverTheReportsOfAFrame) {
  const std::string none = " 00 00 00 00 00 00", first = " 01 01 90 01 20 03", second = " 02 01 a0 0f 90 01",
                    third = " 03 01 b8 01 20 03", third_ends = " 03 00 b8 01 20 03";
  const PenFile file =
      PenFileFolder().read(touches({"03" + first + second, "00" + third + none, "03" + first + second,
                                    "00" + third_ends + none, "03" + first + second, "00" + third + none}));
  ASSERT_EQ(file.strokes.size(), 4u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 10 20, 10 20");
  EXPECT_EQ(places(file.strokes[2]), "11 20");
  EXPECT_EQ(places(file.strokes[3]), "11 20") << "lifted in a report without a count";
}

TEST(ReadHid, ReadsReportsThatHaveNoId) {
  const PenFile file = PenFileFolder().read(
      "R: 29 05 0d 09 42 15 00 25 01 75 08 95 01 81 02 05 01 09 30 09 31 26 ff 00 75 08 95 02 81 02\n"
      "E: 0 3 01 07 09\nE: 1 3 01 08 09\nE: 2 0\nE: 3 3 00 08 09\n");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "7 9, 8 9");
  EXPECT_EQ(file.hovering, 1u);
}

TEST(ReadHid, TakesNoMoreTouchesThanDevicesHave) {
  // 104 tip switches of a bit, then as many ids, x and y of a byte.
  const std::string descriptor_of_104 =
      "R: 28 05 0d 15 00 75 01 95 68 09 42 81 02 75 08 09 51 81 02 05 01 09 30 81 02 09 31 81 02\n";
  std::string report = "E: 0 325";
  for (int i = 0; i < 13; ++i) report += " ff";
  for (int i = 0; i < 312; ++i) report += fmt::format(" {:02x}", i % 104);
  EXPECT_EQ(PenFileFolder().read(descriptor_of_104 + report + "\n").strokes.size(), 64u);
}

TEST(ReadHid, CutsReportsByTheDescriptorOfTheirDevice) {
  const std::string pad = "D:1\nR: 16 05 0d 09 42 15 00 25 01 75 08 95 01 81 02 c0 c0\nN: A Pad\n";
  const PenFile file = PenFileFolder().read("D:0\n" + descriptor + pad +
                                            "D:0\nE: 0 9 02 09 c8 00 19 ff 01 0a f6\nD:1\nE: 0.1 9 02 09 00 "
                                            "00 00 ff 01 0a f6\nD:0\nE: 0.2 9 02 09 90 01 19 ff 03 00 00\n");
  EXPECT_EQ(file.device, "A Pen");
  EXPECT_EQ(file.unit, "mm");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 20 20");
  EXPECT_EQ(PenFileFolder().complaint(descriptor + "D:x\n"), "5: expected the number of a device");
  EXPECT_EQ(PenFileFolder().complaint(descriptor + "D:1\nE: 0 1 00\n"), "6: a report before the descriptor");
}

TEST(ReadHid, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(descriptor + "E: 1 9 02\n"), "5: expected a count of bytes");
  EXPECT_EQ(folder.complaint(descriptor + "E: 1 3 02 08 zz\n"),
            "5: expected as many bytes as the line counts");
  EXPECT_EQ(folder.complaint(descriptor + "E: 1 1 02 08\n"), "5: more bytes than the line counts");
  EXPECT_EQ(folder.complaint("R: 4000000000 05 0d\n"), "1: expected a count of bytes");
  EXPECT_EQ(folder.complaint("R: 2 26 ff\n"), "1: the descriptor is cut off");
  EXPECT_EQ(folder.complaint("R: 14 05 0d 09 42 77 ff ff ff 7f 95 01 81 02 c0\n"),
            "1: the descriptor's reports are longer than any report");
  EXPECT_EQ(folder.complaint("R: 26 05 0d 09 99 75 01 96 ff 7f 85 01 81 02 85 02 09 99 81 02 85 03 09 99 "
                             "81 02 c0\n"),
            "1: the descriptor has more fields than any device");
  EXPECT_EQ(folder.complaint("R: 1 b4\n"), "1: the descriptor pops what was not pushed");
}

}  // namespace
}  // namespace burin
