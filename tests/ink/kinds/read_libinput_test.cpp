#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

/// What libinput record writes, shortened.
const std::string head = R"(# libinput record
version: 1
ndevices: 2
libinput:
  version: "1.22.1"
system:
  os: "debian:12"
devices:
- node: /dev/input/event17
  evdev:
    # Name: Wacom Pen
    name: "Wacom Pen"
    id: [3, 1386, 198, 256]
    codes:
      0: [0, 1, 2] # EV_SYN
      3: [0, 1, 24] # EV_ABS
    absinfo:
      0: [0, 53020, 4, 0, 200]
      1: [0, 33440, 4, 0, 200]
      24: [0, 1023, 0, 0, 0]
    properties: []
  hid: [ 0x05, 0x0d ]
  quirks:
  events:
)";

TEST(ReadLibinput, ReadsEventsInWhateverYamlAlike) {
  const std::string plain = R"(  - evdev:
    - [  0,      0,   3,   0,    2000] # EV_ABS / ABS_X ] 1
    - [  0,      0,   3,   1,    -400]
    - [  0,      0,   1, 330,       1]
    - [  0,      0,   0,   0,       0]
  - evdev:
    - [  1,  10000,   3,   0,    2200]
    - [  1,  10000,   0,   0,       0]
)";
  const std::string other = R"(  - evdev: [[0, 0, 3, 0, 2000], ["0", 0, 3, 1, -400],
       [0, 0, 1, 330, 1],
       [0, 0, 0, 0, 0]]
  - evdev:
    - [1, 10000, 3, 0,
       2200]
    - - 1
      - 10000
      - 0
      - 0
      - 0
)";
  const PenFileFolder folder;
  const PenFile a = folder.read(head + plain), b = folder.read(head + other);
  EXPECT_EQ(places(a.strokes.at(0)), "10 -2, 11 -2");
  EXPECT_EQ(places(b.strokes.at(0)), "10 -2, 11 -2");
  EXPECT_EQ(a.strokes[0].samples[1].time, 1.01);
  EXPECT_EQ(b.strokes[0].samples[1].time, 1.01);
  EXPECT_EQ(folder.complaint(head + plain + "  - evdev:\n    - [1, 2, 3, 4]\n").substr(0, 3), "34:");
  EXPECT_TRUE(folder.read(head + "  - evdev:\n    - run:0\n    - run:0:0\n    - run:0:19\n    - run:99:99\n")
                  .strokes.empty());
}

TEST(ReadLibinput, TakesARunOnceWhateverTheFileSays) {
  const std::string run = R"(    - [0, 0, 3, 0, 2000]
    - [0, 0, 3, 1, 400]
    - [0, 0, 1, 330, 1]
    - [0, 0, 0, 0, 0]
)";
  const std::size_t above = head.size(), first = above + std::string("  - evdev:\n").size();
  std::string text = head + "  - evdev:\n" + run + "  - evdev:\n";
  for (int i = 0; i < 1000; ++i)
    text += "    - run:" + std::to_string(above) + ":" + std::to_string(first) + "\n";
  const PenFile file = PenFileFolder().read(text);
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(file.strokes[0].samples.size(), 1u);
}

TEST(ReadLibinput, HasTheFramesOfATablet) {
  const PenFile file = PenFileFolder().read(head + R"(  # Current time is 12:34:56
  - evdev:
    - [  0,      0,   3,   0,    2000] # EV_ABS / ABS_X
    - [  0,      0,   3,   1,    4000] # EV_ABS / ABS_Y
    - [  0,      0,   1, 320,       1] # EV_KEY / BTN_TOOL_PEN
    - [  0,      0,   0,   0,       0] # ------------ SYN_REPORT (0) ----------
  - evdev:
    - [  0,   5000,   1, 330,       1]
    - [  0,   5000,   3,  24,     341]
    - [  0,   5000,   0,   0,       0]
  - libinput:
    - {time: 0.005, type: TABLET_TOOL_TIP}
  - evdev:
    - [  1,  10000,   3,   0,    2200]
    - [  1,  10000,   0,   0,       0]
- node: /dev/input/event18
  evdev:
    name: "Other"
    absinfo:
      0: [0, 100, 0, 0, 0]
  events:
  - evdev:
    - [  0,   5000,   1, 330,       1]
    - [  0,   5000,   0,   0,       0]
)");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "10 20, 11 20");
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.hovering, 2u);
  EXPECT_NEAR(file.strokes[0].samples[0].pen.pressure, 341 / 1023., 1e-6);
  EXPECT_DOUBLE_EQ(file.strokes[0].samples[1].time, 1.01);
}

// The lines of events are no YAML that is parsed, and still count.
TEST(ReadLibinput, NamesTheLineOfAFaultBelowEvents) {
  const std::string frame = "  - evdev:\n    - [0, 0, 0, 0, 0]\n    - [0, 0, 0, 0, 0]\n";
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(head + frame + frame + "  - evdev:\n    - [0, 0, 3, 0]\n" + frame).substr(0, 3),
            "32:");
  EXPECT_EQ(folder.complaint(head + frame + "  - libinput:\n    - x: [\n").substr(0, 22),
            "30: malformed YAML: en");
}

/// The first frame of a pen that touches.
const std::string frame_of_contact = R"(  - evdev:
    - [0, 0, 3, 0, 2000]
    - [0, 0, 3, 1, 400]
    - [0, 0, 1, 330, 1]
    - [0, 0, 0, 0, 0]
)";

// An item of another kind, or of another depth, ends a run of frames.
TEST(ReadLibinput, TakesFramesOfOneListOnlyTogether) {
  const std::string pen = frame_of_contact + R"(  - evdev:
    - [1, 0, 3, 0, 2200]
    - [1, 0, 0, 0, 0]
)";
  const std::string others = R"(  - evdev:
  - evdev:
    - [2, 0, 3, 0, 2400]
    - [2, 0, 0, 0, 0]
  - other:
    - evdev:
      - [3, 0, 3, 0, 9999]
      - [3, 0, 0, 0, 0]
  - evdev:
    - [4, 0, 3, 0, 2600]
    - [4, 0, 0, 0, 0]
)";
  const PenFile file = PenFileFolder().read(head + pen + others);
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "10 2, 11 2, 12 2, 13 2");
}

TEST(ReadLibinput, HasTheNameOfTheDeviceThatDrew) {
  const std::string pad = "- node: /dev/input/event18\n  evdev:\n    name: \"A Pad\"\n  events:\n";
  const PenFile file = PenFileFolder().read(head + frame_of_contact + pad);
  EXPECT_EQ(file.device, "Wacom Pen");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(PenFileFolder().read(head + pad).device, "A Pad") << "where none drew";
}

TEST(ReadLibinput, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(head + "  - evdev:\n    - [0, 0, 3, 0]\n"),
            "26: an event needs five numbers: sec usec type code value");
  EXPECT_EQ(folder.complaint(head + "  - evdev:\n    - [0, 0, 3, 0, x]\n"), "26: expected a whole number");
  EXPECT_EQ(folder.complaint(head + "  - evdev: [\n").substr(0, 20), "26: malformed YAML: ");
  EXPECT_NE(folder.complaint("libinput:\n" + std::string(100000, '[')), "accepted");
}

}  // namespace
}  // namespace burin
