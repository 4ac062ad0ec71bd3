#include <numbers>

#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

TEST(ReadPointers, HasPointsOfEachShape) {
  const PenFile file =
      PenFileFolder().read(R"([{"type": "stroke", "pointers": [{"y": 2, "x": 1, "t": 1500, "p": 0.5},
    {"x": 3, "y": 4, "p": 1, "t": 1516}]}, {"type": "rectangle", "width": 3}, {"pointerType": "mouse",
    "pointers": [{"x": 5, "y": 6, "t": 7}, {"x": 7, "y": 8}]}])");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_TRUE(file.strokes[0].made_pressure);
  EXPECT_DOUBLE_EQ(file.strokes[0].samples[1].time, 1.516);
  EXPECT_EQ(file.strokes[1].fields, PenFields()) << "a point lacks the time";
  const PenFile lists = PenFileFolder().read(
      R"({"strokes": [{"x": [1, 2], "y": [3, 4], "t": [0, 8], "p": [0, 1], "pressure": [0.5, 0.25], "tiltX": [90, 0]}]})");
  ASSERT_EQ(lists.strokes.size(), 1u);
  EXPECT_FALSE(lists.strokes[0].made_pressure);
  EXPECT_EQ(lists.strokes[0].samples[1].pen.pressure, 0.25F);
  EXPECT_NEAR(lists.strokes[0].samples[0].pen.tilt_x, std::numbers::pi / 2, 1e-6);
}

TEST(ReadPointers, ReadsListsOfListsOfPoints) {
  const PenFile file = PenFileFolder().read(
      R"([[{"time": 0, "x": 1, "y": 2, "pressure": 0.5}, {"time": 8, "x": 3, "y": 4, "pressure": 1}],
          [], [{"x": 5, "y": 6}]])");
  EXPECT_EQ(file.kind, "pointers");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(file.strokes[1].fields, PenFields());
}

TEST(ReadPointers, NamesThePlaceOfAFault) {
  const PenFileFolder folder;
  EXPECT_NE(folder.complaint("[[{\"x\": 1, \"y\": 2}, 7]]"), "accepted");
  EXPECT_EQ(folder.complaint("[{\"pointers\": [{\"x\": 1}]}]"), " [0].pointers[0]: lacks 'y'");
  EXPECT_EQ(folder.complaint("[{\"pointers\":\n [{\"x\": 1, \"y\": nan}]}]"),
            "2: malformed JSON at column 18");
  EXPECT_EQ(folder.complaint("{\"strokes\": [{\"x\": [1], \"y\": [2, 3]}]}"),
            " strokes[0]: x and y differ in their count");
  EXPECT_EQ(folder.complaint("[{\"pointers\": [{\"x\": 1, \"y\": 2, \"p\": 7}]}]"),
            " stroke 1, sample 1: pressure must lie in 0..1");
}

}  // namespace
}  // namespace burin
