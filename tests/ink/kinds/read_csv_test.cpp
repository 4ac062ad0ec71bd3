#include <numbers>

#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

TEST(ReadCsv, TakesColumnsByTheirNames) {
  const PenFile file = PenFileFolder().read(
      "Y;\"X\";note;time_ms;tiltX;pen_down;stroke\r\n1;2;a;0;90;1;1\r\n3;4;;8;0;1;1\r\n\r\n5;6;;16;0;0;1\r\n"
      "7;8;;24;0;1;1\r\n9;9;;32;0;1;2\r\n");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "2 1, 4 3");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .tilt = true}));
  EXPECT_DOUBLE_EQ(file.strokes[0].samples[1].time, 0.008);
  EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_x, std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(places(file.strokes[1]), "8 7");
  EXPECT_EQ(places(file.strokes[2]), "9 9");
  EXPECT_EQ(file.hovering, 1u);
  EXPECT_EQ(file.not_used, std::vector<std::string>{"note"});
}

TEST(ReadCsv, LeavesOutComments) {
  const PenFileFolder folder;
  EXPECT_EQ(places(folder.read("# of a tablet\n# x, y\n1,2\n# 5,6\n3,4\n").strokes.at(0)), "1 2, 3 4");
  EXPECT_EQ(places(folder.read("#\nx;y\n1;2\n").strokes.at(0)), "1 2");
  EXPECT_TRUE(folder.complaint("# x and y\n1,2\n").starts_with(" no pen file that is known"));
}

TEST(ReadCsv, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint("x,y\n1,2\n1,b\n"), "3: expected a number, found 'b'");
  EXPECT_EQ(folder.complaint("x,y\n1,2,3\n"), "2: a line of more than the 2 columns");
  EXPECT_EQ(folder.complaint("x,y\n1\n"), "2: a line without x or y");
  EXPECT_EQ(folder.complaint("x,y,pressure\n1,2,0.5\n3,4,\n"),
            "3: a line has other cells than the first of its stroke");
  EXPECT_EQ(folder.complaint("x,y,pressure\n1,2,1.5\n"), " stroke 1, sample 1: pressure must lie in 0..1");
  EXPECT_EQ(folder.complaint("x,y\n1,inf\n"), "2: expected a number, found 'inf'");
}

}  // namespace
}  // namespace burin
