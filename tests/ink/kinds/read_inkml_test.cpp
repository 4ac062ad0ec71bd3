#include <numbers>

#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

std::string ink(const std::string& content) {
  return "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<ink xmlns=\"http://www.w3.org/2003/InkML\">\n" + content +
         "</ink>\n";
}

TEST(ReadInkml, DecodesDifferencesAndValuesWithoutBlanks) {
  const PenFile file = PenFileFolder().read(ink(R"(<traceFormat><channel name="X" type="integer"/>
    <channel name="Y" type="integer"/><channel name="F" type="integer" max="4000"/></traceFormat>
    <trace>32 635 2757,'34'0'1090,"0"0"-2950,-2 0-100,!1 2 3,*'5*,* * ?</trace>)"));
  ASSERT_EQ(file.strokes.size(), 1u);
  // The force's last difference is 1090, then -1860, then -1960.
  EXPECT_EQ(places(file.strokes[0]), "32 635, 66 635, 100 635, 132 635, 1 637, 1 642, 1 647");
  ASSERT_EQ(file.strokes[0].samples.size(), 7u);
  EXPECT_FLOAT_EQ(file.strokes[0].samples[0].pen.pressure, 2757 / 4000.F);
  EXPECT_FLOAT_EQ(file.strokes[0].samples[1].pen.pressure, 3847 / 4000.F);
  EXPECT_FLOAT_EQ(file.strokes[0].samples[2].pen.pressure, 1987 / 4000.F);
  EXPECT_FLOAT_EQ(file.strokes[0].samples[3].pen.pressure, 27 / 4000.F);
}

TEST(ReadInkml, TakesChannelsFromContextsOfNestedGroups) {
  const PenFile file = PenFileFolder().read(ink(R"(<definitions>
    <context xml:id="a"><inkSource xml:id="s"><traceFormat><channel name="Y"/><channel name="X"/>
      <channel name="T" units="ms"/></traceFormat></inkSource></context>
    <context xml:id="b"><traceFormat><channel name="X"/><channel name="Y"/>
      <intermittentChannels><channel name="F" max="2"/></intermittentChannels></traceFormat></context>
    <context xml:id="c" inkSourceRef="#s"/></definitions>
    <traceGroup contextRef="#b"><traceGroup><trace>1 2 1, 3 4</trace></traceGroup>
      <trace contextRef="#a" timeOffset="500">1 2 100, 3 4 250</trace></traceGroup>
    <trace contextRef="#c">5 6 0</trace><trace type="penUp" contextRef="#c">5 6 0, 7 8 0</trace>)"));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.pressure = true}));
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.5F);
  EXPECT_EQ(places(file.strokes[1]), "2 1, 4 3");
  EXPECT_EQ(file.strokes[1].fields, (PenFields{.time = true}));
  EXPECT_DOUBLE_EQ(file.strokes[1].samples[1].time, 0.75);
  EXPECT_EQ(places(file.strokes[2]), "6 5");
  EXPECT_EQ(file.hovering, 2u);
  EXPECT_EQ(file.unit, "");
}

// The recommendation's Z is the height of the pen above the paper.
TEST(ReadInkml, TakesZForACoordinateOnlyWhereToldSo) {
  const std::string traces =
      R"(<traceFormat><channel name="X"/><channel name="Y"/><channel name="Z"/></traceFormat>
    <trace>1 2 0, 3 4 0.5</trace>)";
  const PenFile height = PenFileFolder().read(ink(traces));
  EXPECT_FALSE(height.strokes.at(0).has_z);
  EXPECT_EQ(height.strokes[0].samples.at(1).position, Vec3d(3, 4, 0));
  EXPECT_EQ(height.not_used, std::vector<std::string>{"Z"});
  const PenFile space = PenFileFolder().read(ink("<annotation type=\"space\">object</annotation>" + traces));
  EXPECT_TRUE(space.strokes.at(0).has_z);
  EXPECT_EQ(space.strokes[0].samples.at(1).position, Vec3d(3, 4, 0.5));
  EXPECT_TRUE(space.not_used.empty());
}

TEST(ReadInkml, CountsTimesInTheUnitsOfTheirChannel) {
  const auto last_time = [](const std::string& channel, const std::string& properties) {
    const PenFile file = PenFileFolder().read(ink(
        R"(<definitions><context xml:id="c"><inkSource><traceFormat><channel name="X"/><channel name="Y"/><channel name="T" )" +
        channel + "/></traceFormat>" + properties +
        R"(</inkSource></context></definitions><trace contextRef="#c">1 2 0, 3 4 20</trace>)"));
    return file.strokes.at(0).samples.at(1).time;
  };
  const auto resolution = [](const std::string& units) {
    return R"(<channelProperties><channelProperty channel="T" name="resolution" value="100" units=")" +
           units + "\"/></channelProperties>";
  };
  EXPECT_DOUBLE_EQ(last_time("", ""), 0.02);
  EXPECT_DOUBLE_EQ(last_time("units=\"seconds\"", ""), 20);
  EXPECT_DOUBLE_EQ(last_time("units=\"dev\"", resolution("1/s")), 0.2);
  EXPECT_DOUBLE_EQ(last_time("units=\"dev\"", resolution("1/dev")), 0.02);
}

TEST(ReadInkml, TakesContextsWithoutAnIdOrAFormat) {
  const PenFile file =
      PenFileFolder().read(ink(R"(<traceFormat><channel name="Y"/><channel name="X"/></traceFormat>
    <definitions><brush xml:id="b"/><context xml:id="inked" brushRef="#b"/></definitions>
    <trace>1 2</trace><trace contextRef="#inked">3 4</trace>
    <context><traceFormat><channel name="X"/><channel name="Y"/></traceFormat></context><trace>5 6</trace>
    <context contextRef="#inked"/><trace>7 8</trace>)"));
  ASSERT_EQ(file.strokes.size(), 4u);
  EXPECT_EQ(places(file.strokes[0]), "2 1");
  EXPECT_EQ(places(file.strokes[1]), "4 3");
  EXPECT_EQ(places(file.strokes[2]), "5 6");
  EXPECT_EQ(places(file.strokes[3]), "8 7");
}

TEST(ReadInkml, TurnsReversedChannelsAndTakesDefaults) {
  const PenFile file =
      PenFileFolder().read(ink(R"(<traceFormat><channel name="X"/><channel name="Y" orientation="-ve"/>
    <intermittentChannels><channel name="F" max="4" default="1"/></intermittentChannels></traceFormat>
    <trace>1 2 3, 4 5</trace>)"));
  EXPECT_EQ(places(file.strokes.at(0)), "1 -2, 4 -5");
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.75F);
  EXPECT_EQ(file.strokes[0].samples[1].pen.pressure, 0.25F);
}

TEST(ReadInkml, InventsNoPressureThatPointsLack) {
  const PenFile file = PenFileFolder().read(ink(R"(<traceFormat><channel name="X"/><channel name="Y"/>
    <channel name="T" units="s"/><channel name="F" max="10"/></traceFormat>
    <trace>1 2 0 ?, 3 4 1 ?</trace><trace>1 2 ? 4, 3 4 ? ?, 5 6 ? 8</trace>)"));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true})) << "no point has a pressure";
  EXPECT_EQ(file.strokes[0].samples[1].pen.pressure, 1);
  EXPECT_EQ(file.strokes[1].fields, (PenFields{.pressure = true}));
  EXPECT_FLOAT_EQ(file.strokes[1].samples[1].pen.pressure, 0.4F) << "that of the point before";
  EXPECT_FLOAT_EQ(file.strokes[1].samples[2].pen.pressure, 0.8F);
}

TEST(ReadInkml, PartsStrokesWhereTheTipIsUp) {
  const PenFile file = PenFileFolder().read(ink(R"(<traceFormat><channel name="X"/><channel name="Y"/>
    <channel name="S" type="boolean"/></traceFormat><trace>0 0 F, 1 2 T, 3 4*, 5 6 F, 7 8 T</trace>)"));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(places(file.strokes[1]), "7 8");
  EXPECT_EQ(file.hovering, 2u);
}

TEST(ReadInkml, ReadsHexadecimalNumbers) {
  const PenFileFolder folder;
  EXPECT_EQ(places(folder.read(ink("<trace>#1f 2,'#A'#0a</trace>")).strokes.at(0)), "31 2, 41 12");
  EXPECT_EQ(folder.complaint(ink("<trace>#g 2</trace>")), "3: expected a number, found '#g 2'");
}

TEST(ReadInkml, JoinsContinuations) {
  const PenFile file = PenFileFolder().read(ink(R"(<trace xml:id="a" continuation="begin">1 2, 3 4</trace>
    <trace xml:id="o">0 0</trace><trace xml:id="b" continuation="middle" priorRef="#a">5 6</trace>
    <trace continuation="end" priorRef="#b">7 <!-- the last -->8</trace><trace priorRef="#a">9 9</trace>)"));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4, 5 6, 7 8");
  EXPECT_EQ(places(file.strokes[1]), "0 0");
  EXPECT_EQ(places(file.strokes[2]), "9 9");
}

TEST(ReadInkml, KeepsTheButtonOfContinuations) {
  const PenFile file = PenFileFolder().read(ink(R"(<context xml:id="c"><inkSource><traceFormat>
    <channel name="X"/><channel name="Y"/><intermittentChannels><channel name="B1" type="boolean"/>
    </intermittentChannels></traceFormat></inkSource></context>
    <trace xml:id="a" contextRef="#c" continuation="begin">1 2</trace>
    <trace contextRef="#c" continuation="end" priorRef="#a">3 4 T</trace>)"));
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_TRUE(file.strokes[0].fields.barrel);
  EXPECT_FALSE(file.strokes[0].samples[0].barrel);
  EXPECT_TRUE(file.strokes[0].samples[1].barrel);
}

TEST(ReadInkml, TakesDefinedTracesThatViewsName) {
  const PenFile file = PenFileFolder().read(ink(R"(<definitions><trace xml:id="a">1 2</trace>
    <traceGroup xml:id="g"><trace>3 4</trace></traceGroup><trace xml:id="unused">5 6</trace></definitions>
    <trace xml:id="here">7 8</trace><traceView><traceView traceDataRef="#g"/><traceView traceDataRef="#here"/>
    </traceView><traceView traceDataRef="#a"/><traceView traceDataRef="#a"/>)"));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "7 8");
  EXPECT_EQ(places(file.strokes[1]), "3 4");
  EXPECT_EQ(places(file.strokes[2]), "1 2");
}

TEST(ReadInkml, HasUnitsOfChannelsAndOfOfficePrograms) {
  const std::string format = R"(<traceFormat><channel name="X" units="cm"/><channel name="Y" units="cm"/>
      <channel name="OTx" units="deg"/><channel name="OTy" units="deg"/></traceFormat>
      <channelProperties><channelProperty channel="X" name="resolution" value="100" units="1/cm"/>
      <channelProperty channel="Y" name="resolution" value="50" units="1/cm"/>
      <channelProperty channel="OTx" name="resolution" value="100" units="1/deg"/></channelProperties>)";
  const std::string trace = "<trace contextRef=\"#c\">100 200 3719 -10</trace>";
  const PenFile device = PenFileFolder().read(
      ink("<context xml:id=\"c\"><inkSource>" + format + "</inkSource></context>" + trace));
  EXPECT_EQ(device.unit, "mm");
  EXPECT_EQ(places(device.strokes.at(0)), "10 40");
  EXPECT_NEAR(device.strokes[0].samples[0].pen.tilt_x, 37.19 * std::numbers::pi / 180, 1e-6);
  EXPECT_NEAR(device.strokes[0].samples[0].pen.tilt_y, -10 * std::numbers::pi / 180, 1e-6);
  const std::string office =
      "<context xml:id=\"c\"><inkSource xml:id=\"inkSrc0\">" + format + "</inkSource></context>";
  EXPECT_EQ(places(PenFileFolder().read(ink(office + trace)).strokes.at(0)), "1 2");
  const PenFile flat =
      PenFileFolder().read(ink(office + "<trace contextRef=\"#c\">100 200 0 0,1 2 0 0</trace>"));
  EXPECT_FALSE(flat.strokes.at(0).fields.tilt) << "not measured";
}

TEST(ReadInkml, HasTheUpperEndWhereAzimuthAndElevationSay) {
  const std::string format = R"(<traceFormat><channel name="X"/><channel name="Y"/>
    <channel name="OA" units="deg"/><channel name="OE" units="deg"/></traceFormat>)";
  const PenFile file = PenFileFolder().read(ink(format + "<trace>0 0 0 60, 0 0 90 60, 0 0 180 90</trace>"));
  const auto& samples = file.strokes.at(0).samples;
  EXPECT_NEAR(samples[0].pen.tilt_x, std::numbers::pi / 6, 1e-6);
  EXPECT_NEAR(samples[0].pen.tilt_y, 0, 1e-6);
  EXPECT_NEAR(samples[1].pen.tilt_x, 0, 1e-6);
  EXPECT_NEAR(samples[1].pen.tilt_y, std::numbers::pi / 6, 1e-6);
  EXPECT_NEAR(samples[2].pen.tilt_x, 0, 1e-6);
  EXPECT_TRUE(file.strokes[0].fields.tilt);
  const PenFile flat = PenFileFolder().read(ink(format + "<trace>0 0 0 0, 1 0 0 0</trace>"));
  EXPECT_FALSE(flat.strokes.at(0).fields.tilt) << "declared and not measured";
}

// A trace has the brush that it names, that its groups name, or that of its context, which may name one that
// stands behind it, or another context that does.
TEST(ReadInkml, TellsToolAndEraserByBrushes) {
  const PenFile file = PenFileFolder().read(ink(R"(<definitions>
    <brush xml:id="a"><brushProperty name="tool" value="pen"/></brush>
    <brush xml:id="b"><brushProperty name="tool" value="pen"/><brushProperty name="eraser" value="true"/></brush>
    <brush xml:id="c"><brushProperty name="width" value="3"/><brushProperty name="eraser" value="false"/></brush>
    <context xml:id="named" brushRef="#b"/>
    <context xml:id="own"><brush><brushProperty name="tool" value="touch"/></brush></context>
    <context xml:id="early" brushRef="#late"/><context xml:id="heir" contextRef="#early"/>
    <brush xml:id="late"><brushProperty name="tool" value="chalk"/></brush></definitions>
    <traceGroup brushRef="#a"><trace>1 2</trace><traceGroup><trace brushRef="#b">1 2</trace></traceGroup></traceGroup>
    <trace contextRef="#named">1 2</trace><trace contextRef="#own">1 2</trace>
    <trace contextRef="#own" brushRef="#c">1 2</trace><trace brushRef="#d">1 2</trace><trace>1 2</trace>
    <trace contextRef="#heir">1 2</trace>)"));
  std::string tools;
  for (const PenStroke& stroke : file.strokes)
    tools += stroke.drawn_by.tool + (stroke.drawn_by.eraser ? " eraser, " : ", ");
  EXPECT_EQ(tools, "pen, pen eraser, pen eraser, touch, , , , chalk, ");
  EXPECT_EQ(
      PenFileFolder().complaint(ink("<brush xml:id='a'><brushProperty name='tool' value='\xff'/></brush>"
                                    "<trace brushRef='#a'>1 2</trace>")),
      " stroke 1: the name of the tool is not valid UTF-8");
}

TEST(ReadInkml, GivesTracesThatNameNoFormatTheOnlyOne) {
  const std::string
      format =
          R"(<traceFormat id="f"><channel name="Y"/><channel name="X"/><channel name="T"/></traceFormat>)",
      trace = "<trace>1 2 0, 3 4 8</trace>";
  const PenFile file =
      PenFileFolder().read("<ink><definitions>" + format +
                           R"(<context id="c" traceFormatRef="#f"/></definitions>)" + trace + "</ink>");
  EXPECT_EQ(places(file.strokes.at(0)), "2 1, 4 3");
  EXPECT_TRUE(file.strokes[0].fields.time);
  const std::string other =
      R"(<traceFormat id="g"><channel name="X"/><channel name="Y"/><channel name="F"/></traceFormat>)";
  EXPECT_NE(
      PenFileFolder().complaint("<ink><definitions>" + format + other + "</definitions>" + trace + "</ink>"),
      "accepted");
}

TEST(ReadInkml, PutsTracesOfContextsWithOtherTimestampsInTheirOrder) {
  const std::string format =
      R"(<traceFormat><channel name="X"/><channel name="Y"/><channel name="T" units="ms"/></traceFormat>)";
  const PenFile file = PenFileFolder().read(
      R"(<ink><definitions><timestamp id="s" time="900000"/>
<context id="a"><inkSource>)" +
      format +
      R"(</inkSource><timestamp id="t" timeString="1970-01-01T01:15:02.5+01:00"/></context>
<context id="b" timestampRef="#s">)" +
      format + R"(</context>
<context id="c">)" +
      format + R"(<timestamp timestampRef="#s" timeOffset="1000"/></context>
<context id="d">)" +
      format + R"(</context><context id="e" contextRef="#a"/></definitions>
<trace contextRef="#a">1 2 0</trace><trace contextRef="#b">1 2 8</trace><trace contextRef="#c">1 2 0</trace>
<trace contextRef="#d">1 2 8</trace><trace contextRef="#e" timeOffset="40">1 2 0</trace></ink>)");
  std::string times;
  for (const PenStroke& stroke : file.strokes) times += std::to_string(stroke.samples.at(0).time) + " ";
  EXPECT_EQ(times, "2.500000 0.008000 1.000000 0.008000 2.540000 ");
}

TEST(ReadInkml, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(ink("<trace>1 2,\n3</trace>")), "3: a point of 1 values, its format has 2");
  EXPECT_EQ(folder.complaint(ink("<trace>1 2 3</trace>")),
            "3: a point of more than the 2 channels of its format");
  EXPECT_EQ(folder.complaint(ink("\n<trace>1 x</trace>")), "4: expected a number, found 'x'");
  EXPECT_EQ(folder.complaint(ink("<trace>1 ?</trace>")), "3: a point without X or Y");
  EXPECT_EQ(folder.complaint(ink("<trace>1e999 2</trace>")), "3: expected a number, found '1e999 2'");
  EXPECT_EQ(
      folder.complaint(ink("<context xml:id=\"a\"><traceFormat><channel name=\"X\"/></traceFormat></context>"
                           "<trace contextRef=\"#b\">1</trace>")),
      "3: names '#b', which has no format");
  EXPECT_EQ(folder.complaint("<ink>\n<trace>1 2</trac"), "2: malformed XML: Start-end tags mismatch");
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<traceGroup>\n";
  for (int i = 0; i < 300; ++i) deep += "</traceGroup>";
  EXPECT_EQ(folder.complaint(ink(deep)), "203: nested deeper than 200 elements");
  const std::string laughs = "<!DOCTYPE ink [<!ENTITY a \"1 2,\">]><ink><trace>&a;</trace></ink>";
  EXPECT_NE(folder.complaint(laughs), "accepted") << "entities of the file are not expanded";
}

}  // namespace
}  // namespace burin
