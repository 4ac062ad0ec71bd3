#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

TEST(ReadExcalidraw, TurnsWhatWasDrawnByHand) {
  const PenFile file = PenFileFolder().read(R"({"type": "excalidraw", "elements": [{"type": "line", "x": 1},
    {"type": "freedraw", "x": 10, "y": 20, "angle": 1.5707963267948966, "points": [[0, 0], [4, 0]],
     "pressures": [0.25, 0]},
    {"type": "freedraw", "isDeleted": true, "x": 1, "y": 2, "points": [[0, 0]]},
    {"type": "freedraw", "x": 1, "y": 2, "points": [[0, 0]], "simulatePressure": true, "pressures": []}]})");
  EXPECT_EQ(file.kind, "excalidraw");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "12 18, 12 22") << "clockwise, y down";
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, 0.25F);
  EXPECT_EQ(file.strokes[1].fields, PenFields());
}

TEST(ReadExcalidraw, HasNoPressureWhereSomePointsLackIt) {
  const PenFile file = PenFileFolder().read(R"({"type": "excalidraw", "elements": [
    {"type": "freedraw", "x": 1, "y": 2, "points": [[0, 0], [1, 1]], "pressures": [0.5]},
    {"type": "freedraw", "x": 1, "y": 2, "points": [[0, 0]], "pressures": [0.5, 0]},
    {"type": "draw", "x": 3, "y": 4, "points": [[0, 0], [1, 1]]}]})");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(file.strokes[0].fields, PenFields());
  EXPECT_EQ(file.strokes[0].samples[0].pen.pressure, Pen().pressure);
  EXPECT_EQ(file.strokes[1].samples.at(0).pen.pressure, 0.5F);
  EXPECT_EQ(places(file.strokes[2]), "3 4, 4 5") << "the name in the program's first versions";
}

TEST(ReadExcalidraw, ReadsItemsOfEachFormInEitherList) {
  const std::string element = R"({"type": "freedraw", "x": 1, "y": 2, "points": [[0, 0], [1, 1]]})",
                    items = "[[" + element + R"(], {"id": "a", "elements": [)" + element + "]}]";
  // Two lists leave the way that reads a file element by element.
  for (const std::string& lists : {"\"libraryItems\": " + items, "\"library\": " + items,
                                   "\"libraryItems\": " + items + ", \"library\": []"}) {
    const PenFile file = PenFileFolder().read(R"({"type": "excalidrawlib", )" + lists + "}");
    ASSERT_EQ(file.strokes.size(), 2u) << lists;
    EXPECT_EQ(file.strokes[0].page, 1u);
    EXPECT_EQ(file.strokes[1].page, 2u);
    EXPECT_EQ(places(file.strokes[1]), "1 2, 2 3");
  }
}

TEST(ReadExcalidraw, NamesThePlaceOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(R"({"type": "excalidraw", "elements": [{"type": "freedraw", "x": 1, "y": 2,
    "points": [[0]]}]})"),
            " elements[0].points[0]: must be a list of x and y");
  EXPECT_EQ(folder.complaint(R"({"type": "excalidraw"})"), " lacks 'elements'");
}

TEST(ReadPointLists, HasTheChannelsThatAllPointsHave) {
  const PenFile file = PenFileFolder().read(
      R"({"a": [[1, 2]], "b": [[1, 2, 0.5, 8], [3, 4, 0.5, 16]], "c": [{"x": 5, "y": 6}], "d": [[1, 2, 0.25], [3, 4]]})");
  EXPECT_EQ(file.kind, "point_lists");
  ASSERT_EQ(file.strokes.size(), 4u);
  EXPECT_EQ(file.strokes[1].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_TRUE(file.strokes[1].made_pressure);
  EXPECT_EQ(file.strokes[1].samples[1].time, 0.016);
  EXPECT_EQ(places(file.strokes[2]), "5 6");
  EXPECT_EQ(file.strokes[3].fields, PenFields());
  EXPECT_EQ(PenFileFolder().complaint(R"({"a": [[1, 2], [3]]})"), " a[1]: must be a list of x and y");
}

TEST(ReadScap, TakesWholePressuresForNone) {
  const auto stroke = [](const std::string& last) {
    return PenFileFolder()
        .read("#9\t9\n@2.0\n{\n\t#0\t4\n\t@2.0\n\t1\t2\t2\n\t3\t4\t" + last + "\n}\n")
        .strokes.at(0);
  };
  EXPECT_EQ(stroke("0").fields, PenFields()) << "marks of what points are";
  EXPECT_EQ(stroke("0").samples.at(0).pen.pressure, 1);
  EXPECT_EQ(PenFileFolder().read("#9 9\n@1\n{\n1 2 0.5\n3 4 1\n}\n").strokes.at(0).fields,
            PenFields{.pressure = true});
}

TEST(ReadScap, TakesZeroPressuresForNone) {
  const PenFile file = PenFileFolder().read("#9 9\n@1\n{\n\t#0\t0\n\t@1\n\t1\t2\t0\n\t3\t4\t0\n}\n");
  EXPECT_EQ(file.kind, "scap");
  ASSERT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, PenFields());
  EXPECT_EQ(PenFileFolder().complaint("#9 9\n@1\n{\n1 2\n}\n"), "4: expected three numbers: x y pressure");
  EXPECT_EQ(PenFileFolder().complaint("#9 9\n@1\n1 2 0\n"), "3: a point outside a stroke");
}

}  // namespace
}  // namespace burin
