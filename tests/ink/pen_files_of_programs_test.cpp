// Compares what is read of real files of drawing programs with what ../shared/data/SOURCES.md states of them.
#include <burin/stroke/pen_angles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ink/pen_files.h"

namespace burin {
namespace {

constexpr double untold = -1, any_range = -2;

/// What is stated of a file, in the units that the reader gives.
struct StatedOfPrograms : test::StatedCounts {
  double least_pressure = untold, most_pressure = untold;
  double least_altitude = untold, most_altitude = untold;  ///< radians
  double ink_seconds = untold;                             ///< sum over the strokes
};

const StatedOfPrograms stated_of_programs[] = {
    {"uim_30_digital_ink_is_processable.uim", "uim", "px", 2787, 177, 5, 63, 0, 0.96, 0.67, 1.04, 57.7},
    {"uim_31_digital_ink_is_processable.uim", "uim", "px", 2789, 178, 2, 63, 0, 0.96, 0.67, 1.04, 59.0},
    {"uim_31_math_structures.uim", "uim", "px", 893, 50, 2, 139, 0, 0.95, 0.53, 0.67, 15.6},
    {"wacom_uim_digital_ink_is_processable.json", "uim_json", "px", 2787, 177, 5, 63, 0, 0.96, 0.67, 1.04,
     57.7},
    {"will_apple.will", "will", "px", 380, 10, 17, 74},
    {"will_elephant.will", "will", "px", 2184, 91, 4, 250},
    {"will_wine.will", "will", "px", 3814, 76, 4, 560},
    {"tilt_toolkit_sketch1.tilt", "tilt", "dm", 912, 5, 11, 493, 0, 1, untold, untold, 44.6},
    {"tilt_perftest_simple.tilt", "tilt", "dm", 32, 3, 7, 13, 0.035, 1, untold, untold, 0.95},
    {"excalidraw_despair.excalidrawlib.xz", "excalidraw", "px", 2142, 137, 4, 198, 0, 0.529},
    {"excalidraw_biology.excalidrawlib.xz", "excalidraw", "px", 7490, 173, 2, 353, 0, 0.490},
    {"excalidraw_handdrawn_signs.excalidrawlib", "excalidraw", "px", 102, 3, 23, 43},
    {"isf_canvas_lasso_pressure.isf", "isf", "mm", 177, 1, 177, 177, 39. / 255, 228. / 255},
    {"isf_multi_stroke_gesture.isf", "isf", "mm", 608, 12, 20, 77},
    {"isf_gif.isf", "isf", "mm", 264, 11, 17, 45},
    {"isf_bezier.isf", "isf", "mm", 1401, 8, 102, 360},
    {"isf_initial_ink.isf", "isf", "mm", 105, 1, 105, 105},
    {"rm_v5_six_pens.rm", "remarkable", "px", 2007, 51, 2, 168, 0, 0.970},
    {"rm_v5_empty_first_layer.rm", "remarkable", "px", 344, 8, 10, 80, 0.014, 0.828},
    {"rm_v5_no_strokes.rm", "remarkable", "px", 0, 0, 0, 0},
    {"rm_v6_color_and_tool.rm", "remarkable", "px", 1370, 25, 18, 143, 3. / 255, 1},
    {"rm_v6_two_layers_points1.rm", "remarkable", "px", 14, 2, 7, 7, 0.044, 0.914},
    {"rm_v6_lines.rm", "remarkable", "px", 469, 10, 2, 64, 0, 1},
    {"perfect_freehand_test_inputs.json", "point_lists", "px", 2041, 12, 1, 675, 0.5, 0.5},
    {"painting30sec.dat", "mypaint", "px", 2253, 30, 4, 454, 0.0059, 0.546},
    {"bdalab_html5_pointer_signal.json", "pointer", "px", 148, 1, 148, 148, 0.0013, 0.608, any_range,
     any_range, 2.48},
    {"bdalab_signal.svc", "svc", "mm", 819, 5, 90, 226, 0, 0.93, 0.907, 1.047},
    {"strokestrip_triceratops.scap", "scap", "px", 10565, 325, 30, 101},
};

/// The range of a value over all samples of strokes that have it.
template <class Value>
void expect_told_range(const PenFile& file, bool PenFields::*field, double least, double most,
                       const Value& value) {
  const test::Range range = test::range_of(file, field, value);
  if (least == any_range) {
    EXPECT_LE(range.least, range.most) << "the file has some";
    return;
  }
  if (least == untold) {
    EXPECT_GT(range.least, range.most) << "the file has none";
    return;
  }
  constexpr double rounding = 0.0051;
  EXPECT_NEAR(range.least, least, rounding);
  EXPECT_NEAR(range.most, most, rounding);
}

double ink_seconds(const PenFile& file) {
  double sum = 0;
  for (const PenStroke& stroke : file.strokes)
    if (stroke.fields.time) sum += stroke.samples.back().time - stroke.samples.front().time;
  return sum;
}

class PenFileOfProgram : public testing::TestWithParam<StatedOfPrograms> {};

TEST_P(PenFileOfProgram, HasWhatIsStatedOfIt) {
  const StatedOfPrograms& expected = GetParam();
  BURIN_SHARED_DATA_OR_SKIP(path, std::string("strokes/") + expected.file);
  const PenFile file = read_pen_file(path);
  ASSERT_NO_FATAL_FAILURE(test::expect_counts(file, expected));
  if (file.strokes.empty()) return;
  expect_told_range(file, &PenFields::pressure, expected.least_pressure, expected.most_pressure,
                    [](const Sample& sample) { return sample.pen.pressure; });
  expect_told_range(file, &PenFields::tilt, expected.least_altitude, expected.most_altitude,
                    [](const Sample& sample) { return std::asin(upper_end(sample.pen).z()); });
  if (expected.ink_seconds == untold) return;
  EXPECT_NEAR(ink_seconds(file), expected.ink_seconds, 0.06);
}

INSTANTIATE_TEST_SUITE_P(, PenFileOfProgram, testing::ValuesIn(stated_of_programs), [](const auto& one) {
  std::string name = one.param.file;
  std::ranges::replace_if(
      name, [](char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
});

PenFile file_of(const std::string& name) {
  const auto path = test::shared_data("strokes/" + name);
  return path ? read_pen_file(*path) : PenFile();
}

test::Range range_of_x(const PenFile& file) {
  test::Range range;
  for (const PenStroke& stroke : file.strokes)
    for (const Sample& sample : stroke.samples) range.extend(sample.position.x());
  return range;
}

TEST(PenFileOfProgramInDetail, HasTheQuirksThatAreStated) {
  if (!test::shared_data("strokes/rm_v6_lines.rm"))
    GTEST_SKIP() << "../shared/data/strokes is not on this machine";
  const PenFile uim = file_of("uim_31_digital_ink_is_processable.uim");
  EXPECT_FALSE(uim.strokes.back().fields.pressure) << "drawn with a mouse";
  EXPECT_FALSE(uim.strokes.back().fields.tilt);
  EXPECT_EQ(uim.strokes.back().drawn_by.tool, "mouse");
  EXPECT_EQ(uim.strokes.front().drawn_by.tool, "pen");
  constexpr double year = 365.25 * 86400;
  EXPECT_NEAR((uim.strokes.back().samples[0].time - uim.strokes.front().samples[0].time) / year, 2.5, 0.3);
  const auto [least, most] = range_of_x(file_of("rm_v6_lines.rm"));
  EXPECT_NEAR(least, -532, 1);
  EXPECT_NEAR(most, -177, 1);
  EXPECT_EQ(file_of("rm_v5_empty_first_layer.rm").strokes.at(0).layer, 2u);
  const PenFile layers = file_of("rm_v6_two_layers_points1.rm");
  EXPECT_NE(layers.strokes.at(0).layer, layers.strokes.at(1).layer);
  EXPECT_EQ(file_of("excalidraw_biology.excalidrawlib.xz").strokes.back().page, 4u);
  EXPECT_TRUE(file_of("tilt_perftest_simple.tilt").strokes.at(0).has_z);
  EXPECT_TRUE(file_of("perfect_freehand_test_inputs.json").strokes.at(1).made_pressure);
}

TEST(PenFileOfProgramInDetail, SaysTheSameInBothWritingsOfTheModel) {
  if (!test::shared_data("strokes/rm_v6_lines.rm"))
    GTEST_SKIP() << "../shared/data/strokes is not on this machine";
  const PenFile binary = file_of("uim_30_digital_ink_is_processable.uim"),
                json = file_of("wacom_uim_digital_ink_is_processable.json");
  ASSERT_EQ(binary.strokes.size(), json.strokes.size());
  for (std::size_t i = 0; i < binary.strokes.size(); ++i) {
    ASSERT_EQ(binary.strokes[i].samples.size(), json.strokes[i].samples.size());
    for (std::size_t k = 0; k < binary.strokes[i].samples.size(); ++k) {
      const Sample &a = binary.strokes[i].samples[k], &b = json.strokes[i].samples[k];
      EXPECT_LT((a.position - b.position).norm(), 1e-9);
      EXPECT_EQ(a.time, b.time);
      EXPECT_EQ(a.pen.pressure, b.pen.pressure);
      EXPECT_EQ(a.pen.tilt_x, b.pen.tilt_x);
    }
  }
}

}  // namespace
}  // namespace burin
