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

TEST(ReadPointers, TellsShapesFromStrokesAndLooksIntoGroups) {
  const std::string stroke = R"({"type": "stroke", "pointers": [{"x": 1, "y": 2, "t": 3, "p": 0.5}]})",
                    shape = R"({"type": "shape", "kind": "polygon", "points": [{"x": 9, "y": 9}]})",
                    edge = R"({"points": [{"x": 8, "y": 8}, {"x": 7, "y": 7}], "type": "edge"})";
  const std::string group = R"({"type": "group", "children": [)" + stroke + ", " + shape +
                            R"(, {"type": "recognized", "strokes": [)" + stroke + "]}]}";
  for (const std::string& text :
       {"[" + shape + ", " + stroke + ", " + edge + ", " + group + "]",
        R"({"strokes": [)" + shape + ", " + edge + ", " + stroke + ", " + group + "]}",
        shape + "\n" + stroke + "\n" + edge + "\n" + group + "\n"}) {
    const PenFile file = PenFileFolder().read(text);
    ASSERT_EQ(file.strokes.size(), 3u) << text;
    for (const PenStroke& one : file.strokes) EXPECT_EQ(places(one), "1 2");
    EXPECT_EQ(file.not_used, (std::vector<std::string>{"shape", "edge"}));
  }
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

TEST(ReadPointers, ReadsAStrokeOfEachLine) {
  const PenFileFolder folder;
  const PenFile file = folder.read(
      "{\"id\": 1, \"points\": [{\"x\": 1, \"y\": 2, \"t\": 5}, {\"x\": 3, \"y\": 4, \"t\": 6}]}\r\n\r\n"
      "{\"x\": [5, 6], \"y\": [7, 8]}\r\n{\r\n\"pointers\": [{\"x\": 9, \"y\": 9}]}\r\n");
  EXPECT_EQ(file.kind, "pointers");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(places(file.strokes[1]), "5 7, 6 8");
  EXPECT_EQ(places(file.strokes[2]), "9 9");
  EXPECT_EQ(folder.complaint("{\"points\": [{\"x\": 1, \"y\": 2}]}\n{\"points\": [{\"x\": 1}]}\n"),
            "2: points[0]: lacks 'y'");
  EXPECT_EQ(folder.complaint("{\"points\": [{\"x\": 1, \"y\": 2}]}\n{\"points\": [{\"x\": 1,"),
            "2: malformed JSON at column 21");
}

TEST(ReadPointers, ReadsManyStrokesOfALine) {
  const PenFileFolder folder;
  const std::string one = R"({"points":[{"x":1,"y":2}]})", other = R"({"points":[{"x":3,"y":4}]})";
  for (const std::string& line :
       {"{\"strokes\":[" + one + "," + other + "]}", "{\"events\":[" + one + "," + other + "]}",
        "{\"strokeGroups\":[{\"strokes\":[" + one + "]},{\"strokes\":[" + other + "]}]}"}) {
    const PenFile file = folder.read(one + "\n" + line + "\n");
    ASSERT_EQ(file.strokes.size(), 3u) << line;
    EXPECT_EQ(places(file.strokes[2]), "3 4") << line;
  }
  EXPECT_EQ(folder.complaint(one + "\n{\"strokes\":[{\"points\":[{\"x\":1}]}]}\n"),
            "2: strokes[0].points[0]: lacks 'y'");
}

TEST(ReadPointers, ReadsAnEventOfEachLine) {
  const PenFileFolder folder;
  const std::string down = R"({"type":"pointerdown","x":1,"y":2,"pressure":0.5,"timeStamp":8})",
                    move = R"({"type":"pointermove","x":3,"y":4,"pressure":0.75,"timeStamp":16})",
                    up = R"({"type":"pointerup","x":3,"y":4,"pressure":0,"timeStamp":24})";
  const PenFile file = folder.read(down + "\n" + move + "\n" + up + "\n" + down + "\n");
  EXPECT_EQ(file.kind, "pointer");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(folder.complaint(down + "\n" + R"({"type":"pointermove","x":3})" + "\n"), "2: lacks 'y'");
  EXPECT_EQ(folder.complaint(down + "\n" + move.substr(0, 30)), "2: malformed JSON at column 31");
}

TEST(ReadPointers, ReadsDrawingsAsPages) {
  const PenFileFolder folder;
  const std::string cat = R"({"word":"cat","drawing":[[[1,3],[2,4],[0,250]],[[5],[6],[500]]]})",
                    dog = R"({"word":"dog","drawing":[[[7,8],[9,10]]]})";
  const PenFile file = folder.read(cat + "\n" + dog + "\n");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].samples[1].time, 0.25);
  EXPECT_EQ(file.strokes[1].page, 1u);
  EXPECT_EQ(places(file.strokes[2]), "7 9, 8 10");
  EXPECT_EQ(file.strokes[2].page, 2u);
  EXPECT_EQ(file.strokes[2].fields, PenFields());
  EXPECT_EQ(folder.read(dog).strokes.size(), 1u);
  EXPECT_EQ(folder.complaint(cat + "\n" + R"({"drawing":[[[7,8],[9]]]})"),
            "2: drawing[0]: lists that differ in their count");
}

TEST(ReadPointers, ReadsPointsInWhateverShapeAlike) {
  const PenFileFolder folder;
  const std::string points[] = {R"({"x": 1, "y": -2.5, "t": 1500, "pressure": 0.5, "p": 1, "tiltX": 90)",
                                R"({"timeStamp": 1508, "y": 3e1, "f": 1, "x": 4, "tiltX": 0, "twist": 90)"};
  const auto file = [&](const std::string& rest) {
    return folder.read(R"([{"pointerType": "PEN", "pointers": [)" + points[0] + rest + "}, " + points[1] +
                       rest + "}]}]");
  };
  // A nested value leaves the way that needs no memory for JSON.
  const PenFile plain = file(R"(, "note": "a")"), whole = file(R"(, "note": {"a": [1]})");
  for (const PenFile& one : {plain, whole}) {
    ASSERT_EQ(one.strokes.size(), 1u);
    const PenStroke& stroke = one.strokes[0];
    EXPECT_EQ(stroke.fields, (PenFields{.time = true, .pressure = true, .tilt = true}));
    EXPECT_FALSE(stroke.made_pressure);
    EXPECT_EQ(stroke.drawn_by.tool, "pen");
    EXPECT_EQ(places(stroke), "1 -2.5, 4 30");
    EXPECT_EQ(stroke.samples[1].time, 1.508);
    EXPECT_EQ(stroke.samples[0].pen.pressure, 0.5F);
    EXPECT_EQ(stroke.samples[1].pen.pressure, 1);
    EXPECT_NEAR(stroke.samples[0].pen.tilt_x, std::numbers::pi / 2, 1e-6);
    EXPECT_EQ(stroke.samples[1].pen.twist, 0) << "a point lacks it";
  }
}

TEST(ReadPointers, ReadsListsOfEvents) {
  const PenFileFolder folder;
  const auto event = [](const char* type, int x, double pressure, const char* rest) {
    char text[200];
    std::snprintf(text, sizeof text,
                  R"({"type": "%s", "clientX": %d, "clientY": 2, "pressure": %g, "timeStamp": %d%s})", type,
                  x, pressure, 8 * x, rest);
    return std::string(text);
  };
  const std::string mouse = R"(, "pointerType": "mouse")", other = R"(, "pointerId": 2)";
  const PenFile typed =
      folder.read("[" + event("pointermove", 0, 0, "") + "," + event("pointerdown", 1, 0.5, mouse.c_str()) +
                  "," + event("pointerdown", 7, 1, other.c_str()) + "," +
                  event("pointermove", 2, 0, mouse.c_str()) + "," + event("pointerup", 3, 0, "") + "]");
  EXPECT_EQ(typed.kind, "pointer");
  ASSERT_EQ(typed.strokes.size(), 2u);
  EXPECT_EQ(places(typed.strokes[0]), "1 2, 2 2");
  EXPECT_EQ(typed.strokes[0].drawn_by.tool, "mouse");
  EXPECT_EQ(typed.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(typed.strokes[0].samples[1].time, 0.016);
  EXPECT_EQ(places(typed.strokes[1]), "7 2");
  EXPECT_EQ(typed.hovering, 2u);
  const PenFile buttons = folder.read(R"([{"x": 1, "y": 2, "buttons": 0}, {"x": 3, "y": 4, "buttons": 1}])");
  EXPECT_EQ(places(buttons.strokes.at(0)), "3 4");
  const std::string events =
      R"([{"x":1,"y":2,"buttons":1},{"x":3,"y":4,"buttons":2},{"x":5,"y":6,"buttons":32},{"x":7,"y":8,"buttons":0}])";
  const std::string arrays = R"({"x":[1,3,5,7],"y":[2,4,6,8],"time":[0,1,2,3],"buttons":[1,2,32,0]})";
  for (const std::string& text : {events, arrays}) {
    const PenFile pen = folder.read(text);
    ASSERT_EQ(pen.strokes.size(), 2u) << text;
    EXPECT_EQ(places(pen.strokes[0]), "1 2, 3 4");
    EXPECT_TRUE(pen.strokes[0].fields.barrel);
    EXPECT_FALSE(pen.strokes[0].drawn_by.eraser);
    EXPECT_FALSE(pen.strokes[0].samples[0].barrel);
    EXPECT_TRUE(pen.strokes[0].samples[1].barrel) << "the button at the side";
    EXPECT_TRUE(pen.strokes[1].drawn_by.eraser);
  }
  EXPECT_FALSE(
      folder.read(R"([{"x":1,"y":2,"buttons":2,"pointerType":"mouse"}])").strokes.at(0).fields.barrel);
  EXPECT_EQ(places(folder.read(R"([{"x": 1, "y": 2}, {"x": 3, "y": 4}])").strokes.at(0)), "1 2, 3 4");
  EXPECT_EQ(folder.complaint(R"([{"x": 1, "y": 2}, {"x": 3}])"), " [1]: lacks 'y'");
  EXPECT_EQ(places(folder.read(R"({"events": [{"pointers": [{"x": 1, "y": 2}]}]})").strokes.at(0)), "1 2");
}

// Of strokes whose reading needs a tree of JSON values and of those that do not.
TEST(ReadPointers, TakesEventsThatTheBrowserPutTogetherForTheOneOfThem) {
  const std::string down =
      R"({"type": "pointerdown", "x": 1, "y": 2, "pressure": 0.25, "timeStamp": 8, "pointerId": 3, "coalescedEvents": []})";
  const std::string move =
      R"({"type": "pointermove", "x": 5, "y": 6, "pressure": 0.75, "timeStamp": 16, "pointerId": 3, "coalescedEvents":
      [{"x": 3, "y": 4, "timeStamp": 12, "pressure": 0.5}, {"x": 5, "y": 6, "timeStamp": 16}]})";
  for (const std::string& text :
       {"[" + down + ", " + move + "]", R"({"page": 1, "events": [)" + down + ", " + move + "]}"}) {
    const PenFile file = PenFileFolder().read(text);
    EXPECT_EQ(file.kind, "pointer");
    ASSERT_EQ(file.strokes.size(), 1u) << text;
    EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4, 5 6");
    EXPECT_EQ(file.strokes[0].samples[1].time, 0.012);
    EXPECT_EQ(file.strokes[0].samples[2].pen.pressure, 0.75F);
  }
}

TEST(ReadPointers, HasTheToolOfEachPointer) {
  const PenFile file = PenFileFolder().read(
      R"([{"x": 1, "y": 2, "buttons": 1, "pointerId": 1, "pointerType": "pen"},
          {"x": 9, "y": 9, "buttons": 1, "pointerId": 2, "pointerType": "touch"}])");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(file.strokes[0].drawn_by.tool, "pen");
  EXPECT_TRUE(file.strokes[0].fields.barrel);
  EXPECT_EQ(file.strokes[1].drawn_by.tool, "touch");
  EXPECT_FALSE(file.strokes[1].fields.barrel);
}

TEST(ReadPointers, ReadsColumnsByTheNamesOfEvents) {
  for (const char* more : {"", R"(, "note": {"a": 1}, "x": [1, 3], "pageX": [9, 9])"}) {
    const PenFile file = PenFileFolder().read(
        R"({"clientX": [1, 3], "clientY": [2, 4], "timeStamp": [0, 8], "buttons": [1, 1])" +
        std::string(more) + "}");
    EXPECT_EQ(file.kind, "pointer");
    EXPECT_EQ(places(file.strokes.at(0)), "1 2, 3 4");
    EXPECT_EQ(file.strokes[0].samples[1].time, 0.008);
  }
}

TEST(ReadPointers, ReadsPointsThatAreListsOfNumbers) {
  const PenFile file = PenFileFolder().read(
      R"({"strokes": [{"points": [[1, 2, 0.25, 10], [3, 4, 1, 20]]}, [[5, 6, 7], [7, 8, 0.5]], [[9, 9]]]})");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(file.strokes[0].samples[1].time, 0.02);
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.25F);
  EXPECT_EQ(file.strokes[1].fields, PenFields()) << "a third number that is no pressure";
  EXPECT_EQ(places(file.strokes[2]), "9 9");
}

TEST(ReadPointers, ReadsListsOfPointsThatAreListsOfNumbers) {
  const PenFile one = PenFileFolder().read("[\n [1, 2, 0.25, 0],\n [3, 4, 0.5, 8]\n]\n");
  EXPECT_EQ(one.kind, "pointers");
  ASSERT_EQ(one.strokes.size(), 1u);
  EXPECT_EQ(places(one.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(one.strokes[0].samples[1].time, 0.008);
  const PenFile more = PenFileFolder().read("[[[1, 2], [3, 4]], [[5, 6]]]");
  ASSERT_EQ(more.strokes.size(), 2u);
  EXPECT_EQ(places(more.strokes[1]), "5 6");
  EXPECT_EQ(PenFileFolder().complaint("[[1, 2], [3]]"), " [1]: must be a list of x and y");
}

TEST(ReadPointers, CallsAPressureOfOneHalfThroughoutTheProgramsOwn) {
  const auto made = [](const char* last) {
    return PenFileFolder()
        .read(R"([{"points": [{"x": 1, "y": 2, "pressure": 0.5}, {"x": 3, "y": 4, "pressure": )" +
              std::string(last) + "}]}]")
        .strokes.at(0)
        .made_pressure;
  };
  EXPECT_TRUE(made("0.5"));
  EXPECT_FALSE(made("0.25"));
}

TEST(ReadPointers, TellsTiltsOfAltitudeAndAzimuth) {
  const PenFileFolder folder;
  const std::string angles =
      R"("x": 1, "y": 2, "altitudeAngle": 0.785398163397, "azimuthAngle": 1.570796326795)";
  for (const std::string& text :
       {"[{\"pointers\": [{" + angles + "}]}]", "[{\"pointers\": [{" + angles + ", \"p\": null}]}]",
        "[{" + angles + ", \"buttons\": 1}]", "[{" + angles + ", \"buttons\": 1, \"tiltX\": null}]"}) {
    const PenFile file = folder.read(text);
    const bool tells_buttons = text.find("buttons") != text.npos;
    EXPECT_EQ(file.strokes.at(0).fields, (PenFields{.tilt = true, .barrel = tells_buttons})) << text;
    EXPECT_NEAR(file.strokes[0].samples.at(0).pen.tilt_x, 0, 1e-6);
    EXPECT_NEAR(file.strokes[0].samples[0].pen.tilt_y, 0.785398, 1e-6);
  }
  const PenFile both = folder.read("[{\"pointers\": [{" + angles + R"(, "tiltX": 90, "tiltY": 0}]}])");
  EXPECT_NEAR(both.strokes.at(0).samples.at(0).pen.tilt_x, 1.570796, 1e-6);
}

// As requests to recognise handwriting have them.
TEST(ReadPointers, TakesStrokesOfGroups) {
  const PenFileFolder folder;
  const std::string groups = R"({"width": 9, "strokeGroups": [{"penStyle": null, "strokes": [)"
                             R"({"x": [1, 2], "y": [3, 4], "t": [0, 8], "p": [0.5, 1]}]},)"
                             R"({"strokes": [{"pointers": [{"x": 5, "y": 6}]}]}])";
  const PenFile file = folder.read(groups + "}");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]) + "; " + places(file.strokes[1]), "1 3, 2 4; 5 6");
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(file.strokes[1].fields, PenFields());
  EXPECT_EQ(folder.complaint(R"({"strokeGroups": [{"strokes": 3}]})").substr(0, 30),
            " strokeGroups[0].strokes: must");
}

TEST(ReadPointers, TakesAPressureThatIsAlways0ForNone) {
  const auto strokes = [](const char* last) {
    return PenFileFolder()
        .read(
            std::string(R"([{"points": [{"x": 1, "y": 2, "pressure": 0}]}, {"points": [{"x": 3, "y": 4, )") +
            R"("pressure": )" + last + "}]}]")
        .strokes;
  };
  EXPECT_EQ(strokes("0").at(1).fields, PenFields());
  EXPECT_EQ(strokes("0").at(1).samples.at(0).pen.pressure, Pen().pressure);
  EXPECT_EQ(strokes("0.5").at(0).fields, (PenFields{.pressure = true}));
  EXPECT_EQ(strokes("0.5").at(0).samples.at(0).pen.pressure, 0);
}

TEST(ReadPointers, TakesNullForAbsent) {
  const PenFile file = PenFileFolder().read(
      R"([{"pointers": [{"x": 1, "y": 2, "t": 0, "p": null}, {"x": 3, "y": 4, "t": 8, "p": 0.5}]}])");
  EXPECT_EQ(file.strokes.at(0).fields, (PenFields{.time = true}));
  EXPECT_NE(PenFileFolder().complaint(R"([{"pointers": [{"x": null, "y": 2}]}])"), "accepted");
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
