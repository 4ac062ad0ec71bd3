#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

TEST(ReadBrushStrokes, ReadsWhatBlenderWrites) {
  const PenFile file = PenFileFolder().read(
      R"(bpy.ops.sculpt.brush_stroke(stroke=[{"name":"", "location":(0.1, 0.2, 0.3), "mouse":(10, 20), "pressure":0.5, "size":25, "pen_flip":False, "time":1.5, "is_start":True},
{"name":'it\'s', "location":(0, 0, 0), "mouse":(12, 30), "pressure":1, "size":30, "pen_flip":False, "time":1.6, "is_start":False},
{"name":"", "location":(0, 0, 0), "mouse":(1, 2), "pressure":1, "size":30, "pen_flip":True, "time":2, "is_start":True,},], mode='NORMAL')
bpy.ops.sculpt.brush_stroke(stroke=[{'location':(0.1, 0.2, 0.3), "time": 0, "x_tilt": 0.5, 'y_tilt': 0}])
)");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "10 -20, 12 -30") << "y down";
  EXPECT_EQ(file.strokes[0].fields, (PenFields{.time = true, .pressure = true}));
  EXPECT_EQ(file.strokes[0].widths, (std::vector<float>{50, 60}));
  EXPECT_TRUE(file.strokes[1].drawn_by.eraser);
  EXPECT_TRUE(file.strokes[2].has_z);
  EXPECT_EQ(file.strokes[2].samples[0].position, Vec3d(0.1, 0.2, 0.3));
  EXPECT_FLOAT_EQ(file.strokes[2].samples[0].pen.tilt_x, 0.785398F);
  EXPECT_FALSE(file.strokes[2].fields.pressure);
}

// Lists are read without a tree of values where they are as Blender writes them, else with one.
TEST(ReadBrushStrokes, ReadsListsWithSomeElementsOfAnotherKind) {
  const PenFile file = PenFileFolder().read(
      R"(f(stroke=[{"mouse":(10, 20), "location":(1, 2, 3), "time":1}, {"location":(4, 5, 6, 7), "time":2}])
f(stroke=[{"mouse":(1, 2, 3), "time":1, "other":{"is_start":[True, None]}}, {"mouse":(4, 5), "is_start":True}])
f(stroke=[]))");
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_TRUE(file.strokes[0].has_z) << "not every element has a place of the mouse";
  EXPECT_EQ(file.strokes[0].samples[0].position, Vec3d(1, 2, 3));
  EXPECT_EQ(file.strokes[0].samples[1].position, Vec3d(4, 5, 6));
  EXPECT_TRUE(file.strokes[0].fields.time);
  EXPECT_EQ(places(file.strokes[1]) + "; " + places(file.strokes[2]), "1 -2; 4 -5");
  EXPECT_FALSE(file.strokes[1].fields.time) << "one element has none";
}

TEST(ReadBrushStrokes, TakesTheLocationsOfScriptsThatLeaveTheMouseAtOnePlace) {
  const PenFile file = PenFileFolder().read(
      R"(f(stroke=[{"mouse":(0, 0), "location":(1, 2, 3)}, {"mouse":(0, 0), "location":(4, 5, 6)}])
f(stroke=[{"mouse":(7, 8), "location":(1, 2, 3)}, {"mouse":(7, 8), "location":(1, 2, 3)}]))");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_TRUE(file.strokes[0].has_z);
  EXPECT_EQ(file.strokes[0].samples[1].position, Vec3d(4, 5, 6));
  EXPECT_EQ(places(file.strokes[1]), "7 -8, 7 -8") << "a click";
}

TEST(ReadBrushStrokes, TakesListsThatScriptsGiveByName) {
  const PenFile file = PenFileFolder().read(
      "import bpy\nbrush_stroke, strokes = None, 3\nstroke = [\n{'mouse': (10, 20), 'time': 0,},\n]\n"
      "bpy.ops.sculpt.brush_stroke(override, stroke=stroke, mode='NORMAL')\nstroke\t=\n[{'mouse': (1, "
      "2)}]\n");
  EXPECT_EQ(file.kind, "brush_stroke");
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]) + "; " + places(file.strokes[1]), "10 -20; 1 -2");
}

TEST(ReadBrushStrokes, NamesThePlaceOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint("\nf(stroke=[{'mouse': (1, 2), 'time': 'late'}])"),
            "2: element 1: time: must be a number, not 'late'");
  EXPECT_EQ(folder.complaint("\nf(stroke=[{'mouse': (1, )}])"),
            "2: element 1: mouse: has 1 numbers, a place needs 2");
  EXPECT_EQ(folder.complaint("\nf(stroke=[{'mouse': (1, 2)},\n{'time': 3}])"),
            "2: element 1: lacks 'location'");
  EXPECT_EQ(folder.complaint("\nf(stroke=[{'mouse': (1, 2)}, 3])"), "2: element 2: must be an object, not 3");
  EXPECT_EQ(folder.complaint("\nf(stroke=[{'mouse': (1, 2}])"), "2: element 1 is malformed");
  EXPECT_EQ(folder.complaint("\nf(stroke=[{'mouse': (1, 2)} 3])"), "2: malformed list");
}

}  // namespace
}  // namespace burin
