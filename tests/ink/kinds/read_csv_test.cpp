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

TEST(ReadCsv, ReadsWhatSpreadsheetsWrite) {
  const PenFileFolder folder;
  const PenFile file = folder.read(
      "\xEF\xBB\xBFsep=;\r\n\"X (cm)\";\"Y [cm]\"; Time (ms) ;note;Pressure (%);Tilt X "
      "(\u00b0);tilt_y_deg;Pen down\r\n"
      "\"1,5\";2,25;8;\"a; b\";50;90;0;TRUE\r\n3;-4,5e1;16;;100,0;0;45;true;\r\n1;1;24;;0;0;0;FALSE\r\n");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "15 22.5, 30 -450");
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true, .tilt = true}));
  EXPECT_DOUBLE_EQ(file.strokes[0].samples[1].time, 0.016);
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.5F);
  EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_x, std::numbers::pi / 2, 1e-6);
  EXPECT_NEAR(file.strokes[0].samples[1].pen.tilt_y, std::numbers::pi / 4, 1e-6);
  EXPECT_EQ(file.hovering, 1u);
  EXPECT_EQ(file.not_used, std::vector<std::string>{"note"});
  const PenFile american = folder.read("x,y\n\"1,5\",\"2,5\"\n");
  EXPECT_EQ(places(american.strokes.at(0)), "1.5 2.5");
}

TEST(ReadCsv, PartsStrokesByTextsToo) {
  const PenFile file =
      PenFileFolder().read("stroke,x,y\nleft,1,2\nleft,3,4\n\"right\",5,6\nleft,7,8\n1,9,9\n1.0,8,8\n");
  ASSERT_EQ(file.strokes.size(), 4u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(places(file.strokes[1]), "5 6");
  EXPECT_EQ(places(file.strokes[2]), "7 8");
  EXPECT_EQ(places(file.strokes[3]), "9 9, 8 8");
}

TEST(ReadCsv, TellsOfTheButtonAtThePensSide) {
  const PenFile file = PenFileFolder().read("stroke,x,y,barrel\n1,2,3,0\n1,3,4,1\n2,4,5,\n");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_TRUE(file.strokes[0].fields.barrel);
  EXPECT_FALSE(file.strokes[0].samples[0].barrel);
  EXPECT_TRUE(file.strokes[0].samples[1].barrel);
  EXPECT_FALSE(file.strokes[1].fields.barrel);

  const PenFile late = PenFileFolder().read("stroke,x,y,barrel\n1,2,3,\n1,3,4,1\n");
  EXPECT_TRUE(late.strokes[0].fields.barrel) << "told in the second line";
  const PenFile turned = PenFileFolder().read("stroke,x,y,eraser\n1,2,3,0\n1,3,4,1\n1,4,4,1\n");
  ASSERT_EQ(turned.strokes.size(), 2u) << "the pen was turned";
  EXPECT_EQ(places(turned.strokes[1]), "3 4, 4 4");
  EXPECT_TRUE(turned.strokes[1].drawn_by.eraser);
}

TEST(ReadCsv, NamesTheTool) {
  const PenFile file = PenFileFolder().read(
      "stroke,x,y,tool\n1,2,3,pen\n1,3,4,pen\n1,4,5,\"a \"\"fat\"\", one\"\n2,5,6,\n2,6,7,NA\n3,7,8,pen\n");
  ASSERT_EQ(file.strokes.size(), 4u) << "a new stroke where the tool changes";
  EXPECT_EQ(file.strokes[0].drawn_by.tool, "pen");
  EXPECT_EQ(places(file.strokes[0]), "2 3, 3 4");
  EXPECT_EQ(file.strokes[1].drawn_by.tool, "a \"fat\", one");
  EXPECT_EQ(file.strokes[2].drawn_by.tool, "");
  EXPECT_EQ(places(file.strokes[2]), "5 6, 6 7");
  EXPECT_EQ(file.strokes[3].drawn_by.tool, "pen");
  EXPECT_EQ(PenFileFolder().read("x,y,pointerType\n1,2,touch\n").strokes.at(0).drawn_by.tool, "touch");
  EXPECT_EQ(PenFileFolder().complaint("x,y,tool\n1,2,a\n1,2,\xff\n"),
            " stroke 2: the name of the tool is not valid UTF-8");
}

TEST(ReadCsv, TakesLineEndsWithinQuotes) {
  const PenFileFolder folder;
  const PenFile file = folder.read(
      "x,note,y\r\n1,\"two\r\n\r\nlines, \"\"quoted\"\"\r\n# no comment\",2\r\n3,5\" "
      "wide,4\r\n5,\"\"\"\",6\r\n"
      "7,\"\n\n\",8\r\n");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4, 5 6, 7 8");
  EXPECT_EQ(folder.complaint("x,y,note\n1,2,\"a\nb\"\n3,4,\"inch\n5,6,b\n7,8,c\n"),
            "4: opens quotes that are not closed");
  EXPECT_EQ(folder.complaint("x,y,note,more\n1,2,\"a\nb\nc\",\"d\ne\n\n"),
            "4: opens quotes that are not closed")
      << "a line within the row";
  EXPECT_EQ(folder.complaint("x,y,note\n1,2,\"a\nb\"\n1,z,3\n"), "4: expected a number, found 'z'");
  EXPECT_EQ(folder.complaint("x,y,note\n1,2,\"" + std::string(1'000'001, '\n')),
            "2: opens quotes that are not closed within 1 MB");
}

TEST(ReadCsv, KnowsTheNamesOfTheUniversalInkLibrary) {
  const PenFile file = PenFileFolder().read(
      "idx,SPLINE_X,SPLINE_Y,SENSOR_TIMESTAMP,SENSOR_PRESSURE,SENSOR_ALTITUDE,SENSOR_AZIMUTH\n"
      "0,1,2,1722443386312.5,0.5,0.785398163,0\n1,3,4,1722443386500.5,0.25,1.570796327,0\n");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(file.unit, "px");
  EXPECT_EQ(places(file.strokes[0]), "1 2");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true, .tilt = true}));
  EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_x, std::numbers::pi / 4, 1e-6);
  EXPECT_NEAR(file.strokes[1].samples[0].time - file.strokes[0].samples[0].time, 0.188, 1e-6);
  EXPECT_TRUE(file.not_used.empty());
  EXPECT_EQ(PenFileFolder().read("idx,x,y\n0,1,2\n1,3,4\n").strokes.size(), 1u) << "an index of rows";
}

TEST(ReadCsv, LeavesOutColumnsOfUnknownUnits) {
  const PenFile file = PenFileFolder().read("x_px,y_px,time (min),timestamp,timestamp_us\n1,2,3,4,5000000\n");
  EXPECT_EQ(file.not_used, (std::vector<std::string>{"time (min)", "timestamp"}));
  EXPECT_EQ(file.unit, "px");
  EXPECT_EQ(file.strokes.at(0).samples.at(0).time, 5);
}

TEST(ReadCsv, LeavesOutPressuresOfWhichNothingTellsTheRange) {
  const PenFile file = PenFileFolder().read("x,y,Pressure\n1,2,0\n3,4,1023\n");
  EXPECT_EQ(file.strokes.at(0).fields, PenFields());
  EXPECT_EQ(file.strokes[0].samples.at(1).pen.pressure, 1);
  EXPECT_EQ(file.not_used, std::vector<std::string>{"Pressure"});
}

TEST(ReadCsv, KnowsTiltsWithoutUnitByTheirSize) {
  const auto read = [](const std::string& names, const std::string& values) {
    return PenFileFolder().read("x,y," + names + "\n1,2," + values + "\n");
  };
  EXPECT_FLOAT_EQ(read("tilt_x,Tilt Y", "-1.5,0.5").strokes.at(0).samples.at(0).pen.tilt_x, -1.5F);
  const PenFile degrees = read("tilt_x,Tilt Y", "-30,0.5");
  EXPECT_NEAR(degrees.strokes.at(0).samples.at(0).pen.tilt_x, -std::numbers::pi / 6, 1e-6);
  EXPECT_NEAR(degrees.strokes[0].samples[0].pen.tilt_y, std::numbers::pi / 360, 1e-6);
  const PenFile unknown = read("tilt_x,Tilt Y", "-3000,500");
  EXPECT_EQ(unknown.strokes.at(0).fields, PenFields());
  EXPECT_EQ(unknown.strokes[0].samples.at(0).pen.tilt_y, 0);
  EXPECT_EQ(unknown.not_used, (std::vector<std::string>{"tilt_x", "Tilt Y"}));
}

TEST(ReadCsv, ReadsTimesOfDays) {
  const PenFile file =
      PenFileFolder().read("time,x,y\n2024-01-01T10:00:00.250,1,2\n\"2024-01-01 10:00:01.5\",3,4\n");
  EXPECT_TRUE(file.strokes.at(0).fields.time);
  EXPECT_DOUBLE_EQ(file.strokes[0].samples.at(1).time - file.strokes[0].samples[0].time, 1.25);
}

TEST(ReadCsv, ReadsLinesThatEndInCarriageReturns) {
  const PenFile file = PenFileFolder().read("# of an old program\rx\ty\tp\r1\t2\tNaN\r3\t4\t\r");
  EXPECT_EQ(places(file.strokes.at(0)), "1 2, 3 4");
  EXPECT_FALSE(file.strokes[0].fields.pressure);
}

// NumPy parts columns by blanks unless told otherwise.
TEST(ReadCsv, PartsColumnsByBlanksWhereAllNamesAreKnown) {
  const PenFileFolder folder;
  const PenFile file = folder.read("# x y time\n 1.0e+00 2 0.5\n3   4 1.5 \n");
  EXPECT_EQ(places(file.strokes.at(0)), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].samples[1].time, 1.5);
  EXPECT_EQ(folder.complaint("x y\n1 2 3\n"), "2: a line of more than the 2 columns");
  EXPECT_TRUE(folder.complaint("x y note\n1 2 3\n").starts_with(" no pen file that is known"));
}

TEST(ReadCsv, TellsTiltsOfAzimuthAndAltitudeWithTheirUnits) {
  const PenFileFolder folder;
  const PenFile file = folder.read("x,y,Azimuth (deg),altitude_rad\n1,2,90,0.5235988\n");
  EXPECT_TRUE(file.strokes.at(0).fields.tilt);
  EXPECT_NEAR(file.strokes[0].samples.at(0).pen.tilt_x, 0, 1e-6);
  EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_y, 1.0471975, 1e-6) << "what is missing to upright";
  for (const char* header :
       {"x,y,azimuth,altitude\n1,2,3,4\n", "x,y,azimuth (deg),altitude (m)\n1,2,3,4\n"}) {
    const PenFile without = folder.read(header);
    EXPECT_FALSE(without.strokes.at(0).fields.tilt);
    EXPECT_EQ(without.not_used.size(), 2u) << header;
  }
}

TEST(ReadCsv, KnowsNamesWithoutUnderscores) {
  const PenFile file = PenFileFolder().read("x,y,penDown,strokeId\n1,2,1,a\n3,4,0,a\n5,6,1,b\n");
  EXPECT_EQ(file.hovering, 1u);
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[1]), "5 6");
  EXPECT_TRUE(file.not_used.empty());
}

TEST(ReadCsv, KnowsContactByTheNamesOfHandwritingSets) {
  for (const char* name : {"pen_status", "PenStatus", "pen_down", "contact"}) {
    const PenFile file = PenFileFolder().read(std::string("x,y,") + name + "\n1,2,1\n3,4,0\n5,6,1\n");
    EXPECT_EQ(file.strokes.size(), 2u) << name;
    EXPECT_EQ(file.hovering, 1u);
  }
}

TEST(ReadCsv, TakesNoMembersOfJsonForColumns) {
  const PenFileFolder folder;
  for (const char* text : {R"({"type": "stroke", "X": [1, 2], "Y": [3, 4]})", R"( {"x":1,"y":2})"})
    EXPECT_TRUE(folder.complaint(text).starts_with(" no pen file that is known")) << text;
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
