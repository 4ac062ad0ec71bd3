#include <numbers>

#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

constexpr double degree = std::numbers::pi / 180;

/// A tablet of 10 and 20 units per mm, with 1000 levels of pressure.
const std::string tablet =
    "# EVEMU 1.2\nN: A Tablet\nI: 0003 056a 00c6 0100\nP: 01 00\nA: 00 100 53020 4 0 10\nA: 01 0 33440 4 0 "
    "20\n"
    "A: 18 0 1000 0 0 0\nA: 1a -64 63 0 0 57\nA: 1b -64 63 0 0 57\n";

/// Events at one time, with the end of their frame.
std::string frame(const std::string& time, std::initializer_list<const char*> events) {
  std::string text;
  for (const char* event : events) text += "E: " + time + " " + event + "\n";
  return text + "E: " + time + " 0000 0000 0\t# ---- SYN_REPORT ----\n";
}

const std::string near = frame("0.000001", {"0003 0000 200", "0003 0001 400", "0003 001a -10", "0003 001b 5",
                                            "0003 0018 1", "0001 0140 1"});

TEST(ReadEvemu, AppliesWhatChangedAtTheEndOfEachFrame) {
  const PenFile file = PenFileFolder().read(
      tablet + near + frame("0.005", {"0001 014a 1", "0003 0018 0250"}) + frame("0.010", {"0003 0000 300"}) +
      frame("0.015", {"0003 0001 600", "0003 0018 0", "0003 001a 20"}) +
      frame("0.020", {"0003 0000 0", "0003 0001 0", "0003 0018 0", "0001 014a 0", "0001 0140 0"}));
  EXPECT_EQ(file.device, "A Tablet");
  EXPECT_EQ(file.unit, "mm");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 20 20, 20 30");
  EXPECT_EQ(file.hovering, 2u);
  const auto& samples = file.strokes[0].samples;
  EXPECT_FLOAT_EQ(samples[0].pen.pressure, 0.25F);
  EXPECT_EQ(samples[2].pen.pressure, 0) << "pressure 0 in contact is a sample";
  EXPECT_FLOAT_EQ(samples[1].pen.tilt_x, static_cast<float>(-10 * degree));
  EXPECT_FLOAT_EQ(samples[2].pen.tilt_x, static_cast<float>(20 * degree));
  EXPECT_DOUBLE_EQ(samples[2].time, 0.015);
}

TEST(ReadEvemu, HasTheEraserOfAFrameInWhateverOrder) {
  const PenFile file = PenFileFolder().read(
      tablet + frame("1", {"0003 0000 200", "0003 0001 400", "0001 014a 1", "0001 0141 1"}) +
      frame("2", {"0001 014a 0", "0001 0141 0"}) + frame("3", {"0001 014a 1", "0001 0147 1"}));
  ASSERT_EQ(file.strokes.size(), 1u) << "a puck makes none";
  EXPECT_TRUE(file.strokes[0].drawn_by.eraser);
  EXPECT_EQ(file.strokes[0].samples.size(), 1u);
  EXPECT_FALSE(file.strokes[0].fields.pressure) << "the range is there, and nothing was sent";
}

TEST(ReadEvemu, EndsAStrokeWhereEventsWereLost) {
  const PenFile file = PenFileFolder().read(
      tablet + frame("1", {"0003 0000 200", "0003 0001 400", "0001 014a 1"}) + frame("2", {"0003 0000 300"}) +
      "E: 3 0000 0003 0\n" + frame("3", {"0003 0000 900"}) + frame("4", {"0003 0000 500"}));
  ASSERT_EQ(file.strokes.size(), 2u) << "of a device that never sends a tool";
  EXPECT_EQ(places(file.strokes[1]), "40 20");
}

TEST(ReadEvemu, KnowsTheUnitOfTiltsWithoutResolutionByTheirRange) {
  for (const auto& [range, value] :
       std::vector<std::pair<const char*, const char*>>{{"-9000 9000 0 0", "3000"},
                                                        {"-900 900 0 0 0", "300"},
                                                        {"-90 90 0 0", "30"},
                                                        {"0 127 0 0", "94"}}) {
    const PenFile file = PenFileFolder().read("# EVEMU 1.1\nA: 00 0 100 0 0\nA: 01 0 100 0 0\nA: 1a " +
                                              std::string(range) + "\nA: 1b " + range + "\n" +
                                              frame("1", {"0003 0000 20", "0003 0001 40", "0001 014a 1",
                                                          ("0003 001a " + std::string(value)).c_str(),
                                                          ("0003 001b " + std::string(value)).c_str()}));
    EXPECT_FLOAT_EQ(file.strokes.at(0).samples.at(0).pen.tilt_x, static_cast<float>(30 * degree)) << range;
  }
}

TEST(ReadEvemu, HasWhatIsSentForTheFirstTimeWithinAStroke) {
  const PenFile file = PenFileFolder().read(
      tablet + frame("1", {"0003 0000 200", "0003 0001 400", "0003 001a 30", "0001 014a 1"}) +
      frame("2", {"0003 0018 500"}) + frame("3", {"0003 001b -20"}));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true, .tilt = true}));
  const auto& samples = file.strokes[0].samples;
  EXPECT_EQ(samples.at(0).pen.pressure, 0);
  EXPECT_EQ(samples.at(1).pen.pressure, 0.5F);
  EXPECT_FLOAT_EQ(samples[0].pen.tilt_x, static_cast<float>(30 * degree));
  EXPECT_EQ(samples[1].pen.tilt_y, 0);
  EXPECT_FLOAT_EQ(samples.at(2).pen.tilt_y, static_cast<float>(-20 * degree));
}

TEST(ReadEvemu, HasTheTwistOfPensThatMeasureIt) {
  const std::string axis = "A: 02 -900 899 0 0 287\n";
  const std::string down = frame("1", {"0003 0000 200", "0003 0001 400", "0003 0002 450", "0001 014a 1"});
  const PenFile still = PenFileFolder().read(tablet + axis + down + frame("2", {"0003 0000 300"}));
  EXPECT_FALSE(still.strokes.at(0).fields.twist);
  const PenFile file = PenFileFolder().read(tablet + axis + down + frame("2", {"0003 0002 -900"}));
  ASSERT_TRUE(file.strokes.at(0).fields.twist);
  EXPECT_NEAR(file.strokes[0].samples.at(0).pen.twist, 0, 1e-6);
  EXPECT_NEAR(file.strokes[0].samples.at(1).pen.twist, 90 * degree, 1e-6);
}

TEST(ReadEvemu, TellsOfTheButtonsAtThePensSide) {
  const PenFile file = PenFileFolder().read(
      tablet + frame("1", {"0003 0000 200", "0003 0001 400", "0001 0140 1", "0001 014a 1"}) +
      frame("2", {"0001 014a 0"}) + frame("3", {"0001 014a 1"}) + frame("4", {"0001 014b 1"}) +
      frame("5", {"0003 0000 300"}) + frame("6", {"0001 014b 0"}) + frame("7", {"0001 014c 1"}));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_FALSE(file.strokes[0].fields.barrel) << "none was sent yet";
  EXPECT_TRUE(file.strokes[1].fields.barrel);
  std::string held;
  for (const Sample& sample : file.strokes[1].samples) held += sample.barrel ? '1' : '0';
  EXPECT_EQ(held, "01101");
}

/// A screen that has slots, and a pen too.
const std::string screen =
    "# EVEMU 1.3\nA: 00 0 4000 0 0 20\nA: 01 0 3000 0 0 20\nA: 2f 0 9 0 0 0\n"
    "A: 35 100 4000 0 0 20\nA: 36 0 3000 0 0 20\nA: 39 0 65535 0 0\nA: 3a 0 255 0 0\n";

TEST(ReadEvemu, PartsTouchesBySlots) {
  const PenFile file =
      PenFileFolder().read(screen +
                           frame("1", {"0003 0039 7", "0003 0035 100", "0003 0036 200", "0003 003a 51",
                                       "0001 014a 1", "0003 0000 100", "0003 0001 200"}) +
                           frame("2", {"0003 002f 1", "0003 0039 8", "0003 0035 2100", "0003 0036 2000"}) +
                           frame("3", {"0003 002f 0", "0003 0039 -1", "0003 0000 2100", "0003 0001 2000"}) +
                           frame("4", {"0003 002f 1", "0003 0036 2020", "0003 0001 2020"}) +
                           frame("5", {"0003 002f 0", "0003 0039 9", "0003 0035 140"}) +
                           frame("6", {"0003 0039 -1", "0003 002f 1", "0003 0039 -1", "0001 014a 0"}));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "0 10") << "none where only the other touch moves";
  EXPECT_EQ(places(file.strokes[1]), "100 100, 100 101");
  EXPECT_EQ(places(file.strokes[2]), "2 10") << "the slot keeps what does not change";
  EXPECT_EQ(file.strokes[0].drawn_by.tool, "touch");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.2F);
  EXPECT_EQ(file.strokes[1].fields, (PenFields{.time = true}));
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.hovering, 1u);
}

TEST(ReadEvemu, PassesOverSlotsBeyondAnyDevice) {
  const PenFile file = PenFileFolder().read(
      screen + frame("1", {"0003 002f 64", "0003 0039 1", "0003 0035 300", "0003 0036 20", "0003 002f -1",
                           "0003 0039 2", "0003 0035 300", "0003 0036 20", "0003 002f 63", "0003 0039 3",
                           "0003 0035 500", "0003 0036 20"}));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "20 1");
}

TEST(ReadEvemu, EndsTouchesWhereEventsWereLost) {
  const PenFile file = PenFileFolder().read(
      screen + frame("1", {"0003 0039 5", "0003 0035 300", "0003 0036 20"}) + "E: 2 0000 0003 0\n" +
      frame("2", {"0003 0035 900"}) + frame("3", {"0004 0004 1"}) + frame("4", {"0003 0035 500"}) +
      frame("5", {"0003 0039 -1"}) + frame("6", {"0003 0035 700"}));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "10 1");
  EXPECT_EQ(places(file.strokes[1]), "20 1") << "a place tells that the touch goes on";
  EXPECT_EQ(file.hovering, 4u);
}

/// A screen of the kernel's multi-touch protocol of type A, as evemu-record writes it.
const std::string anonymous =
    "# EVEMU 1.3\n# Kernel: 2.6.38\n# Input device name: \"Anonymous Touchscreen\"\nN: Anonymous "
    "Touchscreen\n"
    "I: 0018 0eef 0001 0100\nP: 02 00 00 00 00 00 00 00\nB: 00 0b 00 00 00 00 00 00 00\n"
    "A: 30 0 255 0 0 0\nA: 35 0 4095 0 0 20\nA: 36 0 4095 0 0 20\nA: 3a 0 255 0 0 0\n";

const char* const packet_end = "0000 0002 0000\t# ++++++++++++ SYN_MT_REPORT (0) ++++++++++";

// The sequences are those of the protocol's example: a packet for each touch, the rest after one is lifted,
// an empty packet after the last.
TEST(ReadEvemu, FollowsTouchesOfFramesThatTellAllAnewByTheirPlaces) {
  const PenFile file = PenFileFolder().read(
      anonymous +
      frame("1",
            {"0003 0035 100", "0003 0036 200", packet_end, "0003 0035 3000", "0003 0036 2000", packet_end}) +
      frame("2",
            {"0003 0035 2980", "0003 0036 2000", packet_end, "0003 0035 120", "0003 0036 200", packet_end}) +
      frame("3", {"0003 0035 2960", "0003 0036 2000", packet_end}) + frame("4", {packet_end}) +
      frame("5", {"0003 0035 2940", "0003 0036 2000", packet_end}));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "5 10, 6 10") << "in whatever order the packets come";
  EXPECT_EQ(places(file.strokes[1]), "150 100, 149 100, 148 100");
  EXPECT_EQ(places(file.strokes[2]), "147 100") << "all were lifted before";
  EXPECT_EQ(file.strokes[0].drawn_by.tool, "touch");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true}));
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.hovering, 1u);
}

TEST(ReadEvemu, FollowsTouchesOnceWhereADeviceHasSlotsAndEndsPacketsToo) {
  const PenFile file = PenFileFolder().read(
      screen + frame("1", {"0003 0039 5", "0003 0035 300", "0003 0036 20", packet_end}) +
      frame("2", {"0003 0035 500", packet_end}) + frame("3", {"0003 0039 -1", packet_end}));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "10 1, 20 1");
}

TEST(ReadEvemu, FollowsTouchesWithoutSlotsByTheirIds) {
  const auto touch = [](const char* id, const char* x) {
    return std::vector<const char*>{id, x, "0003 0036 200", "0003 003a 51", packet_end};
  };
  const auto frame_of = [&](const std::string& time, std::vector<std::vector<const char*>> touches) {
    std::string text;
    for (const auto& events : touches)
      for (const char* event : events) text += "E: " + time + " " + event + "\n";
    return text + "E: " + time + " 0000 0000 0\n";
  };
  const PenFile file = PenFileFolder().read(
      anonymous +
      frame_of("1", {touch("0003 0039 0", "0003 0035 100"), touch("0003 0039 1", "0003 0035 200")}) +
      frame_of("2", {touch("0003 0039 0", "0003 0035 200"), touch("0003 0039 1", "0003 0035 100")}) +
      frame_of("3", {touch("0003 0039 2", "0003 0035 200")}));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "5 10, 10 10") << "the ids tell that they crossed";
  EXPECT_EQ(places(file.strokes[1]), "10 10, 5 10");
  EXPECT_EQ(places(file.strokes[2]), "10 10");
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.2F);
}

TEST(ReadEvemu, EndsTouchesWithoutSlotsWhereNoPacketTellsSo) {
  const char* const x = "0003 0035 100";
  const char* const y = "0003 0036 200";
  const PenFile file = PenFileFolder().read(
      anonymous + frame("1", {x, y, packet_end, "0001 014a 1"}) + frame("2", {"0001 0066 1"}) +
      frame("3", {x, y, packet_end}) + frame("4", {"0001 014a 0"}) + frame("5", {x, y, packet_end}) +
      frame("6", {"0003 0018 0"}) + frame("7", {x, y, packet_end}) +
      frame("8", {"0003 0030 0", x, y, packet_end}) + frame("9", {x, y, "0003 003b 3", packet_end}) +
      frame("10", {x, packet_end}) + frame("11", {x, y, packet_end}) + "E: 12 0000 0003 0\n" +
      frame("12", {packet_end}) + frame("13", {x, y, packet_end}));
  ASSERT_EQ(file.strokes.size(), 5u);
  EXPECT_EQ(file.strokes[0].samples.size(), 2u) << "a key ends no touch";
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(file.strokes[i].samples.size(), 1u) << i;
}

TEST(ReadEvemu, LeavesTheOnePointerToTouchesWithoutSlots) {
  const auto touch = [](const std::string& time, const char* touch_x, const char* x) {
    return frame(time, {touch_x, "0003 0036 200", packet_end, "0001 014a 1", x, "0003 0001 40"});
  };
  const PenFile file = PenFileFolder().read(anonymous + "A: 00 0 4095 0 0 20\nA: 01 0 4095 0 0 20\n" +
                                            touch("1", "0003 0035 100", "0003 0000 100") +
                                            touch("2", "0003 0035 120", "0003 0000 120") +
                                            frame("3", {packet_end, "0001 014a 0"}));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "5 10, 6 10");
}

TEST(ReadEvemu, FindsSlotsThatNoDescriptionHas) {
  const PenFile file = PenFileFolder().read(
      "# EVEMU 1.3\n" + frame("1", {"0003 002f 0", "0003 0039 5", "0003 0035 7", "0003 0036 8"}));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(file.strokes[0].drawn_by.tool, "touch");
}

TEST(ReadEvemu, GoesOnWithATouchWhoseIdIsSentAgain) {
  const PenFile file =
      PenFileFolder().read(screen + frame("1", {"0003 0039 5", "0003 0035 300", "0003 0036 20"}) +
                           frame("2", {"0003 0039 5", "0003 0035 500"}) + frame("3", {"0003 0039 6"}));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "10 1, 20 1");
}

TEST(ReadEvemu, KeepsThePenBesideAPalm) {
  const PenFile file = PenFileFolder().read(
      screen + frame("1", {"0003 0039 5", "0003 0035 300", "0003 0036 20"}) +
      frame("2", {"0001 0140 1", "0003 0000 1000", "0003 0001 1000"}) + frame("3", {"0001 014a 1"}) +
      frame("4", {"0003 002f 1", "0003 0039 6", "0003 0035 500", "0003 0036 20"}) +
      frame("5", {"0003 0000 1100"}) + frame("6", {"0001 014a 0", "0001 0140 0"}) +
      frame("7", {"0001 0145 1", "0001 014a 1", "0003 0000 300"}));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "10 1");
  EXPECT_EQ(places(file.strokes[1]), "50 50, 50 50, 55 50") << "no finger's place";
  EXPECT_EQ(file.strokes[1].drawn_by.tool, "") << "the pen";
  EXPECT_EQ(places(file.strokes[2]), "20 1");
  EXPECT_EQ(file.hovering, 0u) << "the palm rests";
}

TEST(ReadEvemu, LeavesOutFingersAboveTheScreen) {
  const PenFile file = PenFileFolder().read(
      screen + frame("1", {"0003 0039 5", "0003 0035 300", "0003 0036 20", "0003 003b 1"}) +
      frame("2", {"0003 0035 500"}) + frame("3", {"0003 003b 0"}) + frame("4", {"0003 003b 1"}) +
      frame("5", {"0003 003b 0", "0003 0035 700"}) + frame("6", {"0003 0039 -1"}));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "20 1");
  EXPECT_EQ(places(file.strokes[1]), "30 1");
  EXPECT_EQ(file.hovering, 4u);
}

TEST(ReadEvemu, TakesTheDescriptionBesideTheRecording) {
  const PenFileFolder folder;
  folder.write("pen.desc", "# EVEMU 1.0\nN: Short\n");
  folder.write("pen_4x5.desc",
               "# EVEMU 1.1\nN: Old\nA: 00 0 1000 0 0\nA: 01 0 1000 0 0\nA: 18 100 300 0 0\n"
               "A: 1a 0 127 0 0\nA: 1b 0 127 0 0\n");
  const std::string events = frame("7", {"0003 0000 200", "0003 0001 400", "0003 001a 74", "0003 001b 64",
                                         "0003 0018 200", "0001 014a 1"});
  const PenFile file = read_pen_file(folder.write("pen_4x5_drag.events", events));
  EXPECT_EQ(file.device, "Old");
  EXPECT_EQ(file.unit, "") << "no resolution";
  const Sample& sample = file.strokes.at(0).samples.at(0);
  EXPECT_EQ(sample.position, Vec3d(200, 400, 0));
  EXPECT_EQ(sample.pen.pressure, 0.5F);
  EXPECT_FLOAT_EQ(sample.pen.tilt_x, static_cast<float>(10 * degree)) << "64 is upright";
  EXPECT_EQ(sample.pen.tilt_y, 0);
  const PenFile alone = read_pen_file(folder.write("other.events", events));
  EXPECT_EQ(alone.strokes.at(0).fields, (PenFields{.time = true})) << "no ranges, no pressure and no tilt";
}

TEST(ReadEvemu, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint("# EVEMU 1.2\nE: 1 0003 0000\n"), "2: expected an event: time type code value");
  EXPECT_EQ(folder.complaint("# EVEMU 1.2\n\nE: x 0003 0000 1\n"), "3: expected a time, seconds");
  EXPECT_EQ(folder.complaint("# EVEMU 1.2\nE: 1 0003 0000 99999999999\n"),
            "2: expected an event: time type code value");
  EXPECT_EQ(folder.complaint("# EVEMU 1.2\nA: 00 0 x 0 0\n"),
            "2: expected an axis: code min max fuzz flat resolution");
}

}  // namespace
}  // namespace burin
