// Compares what pen_file_facts.h makes of real files with what ../shared/data/SOURCES.md states of them:
// lengths of strokes, rates and intervals, levels of pressure, repeated places and times. Counts, ranges and
// units are those of pen_file_test.cpp and pen_files_of_programs_test.cpp.
#include <burin/ink/pen_file_facts.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "ink/pen_files.h"

namespace burin {
namespace {

constexpr double not_stated = -1;

/// Facts of a file; intervals between samples are in milliseconds.
struct StatedFacts {
  const char* file;
  double median_length = not_stated;  ///< samples of a stroke
  double rate = not_stated, median_interval = not_stated, least_interval = not_stated,
         most_interval = not_stated;
  double pressure_levels = not_stated, without_pressure = not_stated;
  double duplicates = not_stated, equal_stamps = not_stated;
};

const StatedFacts stated_facts[] = {
    {"bdalab_html5_pointer_signal.json", 148, 59.3, 16.1, 7.4, 38},
    {"bdalab_signal.svc", 167, 133.1, 8, 7, 8, 416, not_stated, 112},
    {"evemu_cintiq_12wx.events", 120, 133.6, 7.1, 6, 9.1},
    {"evemu_genius_i405x_hover.events", 0},
    {"evemu_intuos4_6x9_stylus_drag.events", 295, 200.3, 4, 3.9, 8.1, not_stated, not_stated, 14},
    {"evemu_uclogic_wp5540u_pen.events", 459, 114.3, 8, 7.9, 32},
    {"excalidraw_biology.excalidrawlib.xz", 14, 0, 0, 0, 0, 454},
    {"excalidraw_despair.excalidrawlib.xz", 11, 0, 0, 0, 0, 403},
    {"excalidraw_handdrawn_signs.excalidrawlib", 36, 0, 0, 0, 0, 0},
    {"hid_intuospro_m_eraser_ccw_circle.hid", 399, 199.7, 5.9, 0.9, 31.1, 174},
    {"hid_intuospro_m_pen_strong_vertical.hid", 281, 201.3, 5.9, 1.9, 7.2},
    {"hid_intuospro_m_pen_two_horizontal.hid.xz", 195, 201, 5.9, 2.1, 6.9},
    {"inkml_inkmljs_ink1.inkml", 35, 0, 0, 0, 0, not_stated, not_stated, 84},
    {"isf_bezier.isf", 166, 0, 0, 0, 0, 0},
    {"isf_canvas_lasso_pressure.isf", 177, 0, 0, 0, 0, 94},
    {"isf_gif.isf", 19, 0, 0, 0, 0, 0},
    {"isf_initial_ink.isf", 105, 0, 0, 0, 0, 0},
    {"isf_multi_stroke_gesture.isf", 54, 0, 0, 0, 0, 0, 0, 305},
    // Its 262 levels are those of all events: 0 is that of the lifted pen.
    {"painting30sec.dat", 19, 97.6, 8, 7, 40, 261, 0},
    {"perfect_freehand_test_inputs.json", not_stated, not_stated, not_stated, not_stated, not_stated, 1},
    {"pointer_iink_diagram_1.json", 11, 39.6, 17, 1, 167},
    {"pointer_iink_hello.json", 44, 25.8, 30, 14, 433},
    {"rm_v5_empty_first_layer.rm", 42, 0, 0, 0, 0},
    {"rm_v5_no_strokes.rm", 0, 0, 0, 0, 0, 0},
    {"rm_v5_six_pens.rm", 28, 0, 0, 0, 0, 1948, 41, 32},
    {"rm_v6_color_and_tool.rm", 43, 0, 0, 0, 0},
    {"rm_v6_lines.rm", 49, 0, 0, 0, 0, not_stated, 61},
    {"rm_v6_two_layers_points1.rm", 7, 0, 0, 0, 0},
    {"strokestrip_triceratops.scap", 31, 0, 0, 0, 0, 0},
    {"tilt_perftest_simple.tilt", 12, 30.5, 23, 11, 89, 10},
    {"tilt_toolkit_sketch1.tilt", 73, 20.4, 45, 11, 245, 11},
    {"uim_30_digital_ink_is_processable.uim", 15, 45.2, 9, 0, 96, 94, 328, 660, 202},
    {"uim_31_digital_ink_is_processable.uim", 15, 44.2, 9, 0, 1301, 94, 328},
    {"uim_31_math_structures.uim", 12, 54, 16, 0, 342, 78},
    {"wacom_uim_digital_ink_is_processable.json", 15, 45.2, 9, 0, 96, 94, not_stated, 660, 202},
    {"will_apple.will", 31, 0, 0, 0, 0, 0},
    {"will_elephant.will", 8, 0, 0, 0, 0, 0},
    {"will_wine.will", 17, 0, 0, 0, 0, 0},
    {"xopp_load_strokes.xopp", 58, 0, 0, 0, 0, 0},
    {"xopp_xournal_stroke_line_return.xoj", 51, 0, 0, 0, 0, 0},
    {"xopp_zip_stroke.xopp", 90, 0, 0, 0, 0, 0},
};

/// The mean of the two in the middle of an even count, without its fraction.
double median_length(const PenFile& file) {
  std::vector<std::size_t> lengths;
  for (const PenStroke& stroke : file.strokes) lengths.push_back(stroke.samples.size());
  if (lengths.empty()) return 0;
  std::ranges::sort(lengths);
  return static_cast<double>((lengths[(lengths.size() - 1) / 2] + lengths[lengths.size() / 2]) / 2);
}

double pressure_levels(const PenFile& file) {
  std::set<float> levels;
  for (const PenStroke& stroke : file.strokes)
    if (stroke.fields.pressure)
      for (const Sample& sample : stroke.samples) levels.insert(sample.pen.pressure);
  return static_cast<double>(levels.size());
}

/// `rounding`: half a unit of the last digit that is stated, and a little more, since some are cut off.
void expect_stated(double value, double stated, double rounding, const char* what) {
  if (stated != not_stated) EXPECT_NEAR(value, stated, rounding) << what;
}

class PenFileFactsOfOthers : public testing::TestWithParam<StatedFacts> {};

TEST_P(PenFileFactsOfOthers, AreThoseThatAreStated) {
  const StatedFacts& stated = GetParam();
  BURIN_SHARED_DATA_OR_SKIP(path, std::string("strokes/") + stated.file);
  const PenFile file = read_pen_file(path);
  const PenFileFacts facts = facts_of(file);
  const ValueRange interval = facts.interval.value_or(ValueRange());
  constexpr double ms = 1000, tenth = 0.06;
  // Those from 10 ms on are stated as whole ones.
  const auto rounding = [](double interval_stated) { return interval_stated < 10 ? tenth : 0.51; };
  expect_stated(median_length(file), stated.median_length, 0, "median length");
  expect_stated(facts.rate, stated.rate, tenth, "rate");
  expect_stated(ms * facts.median_interval, stated.median_interval, tenth, "median interval");
  expect_stated(ms * interval.least, stated.least_interval, rounding(stated.least_interval),
                "least interval");
  expect_stated(ms * interval.most, stated.most_interval, rounding(stated.most_interval), "most interval");
  expect_stated(pressure_levels(file), stated.pressure_levels, 0, "levels of pressure");
  expect_stated(static_cast<double>(facts.without_pressure), stated.without_pressure, 0, "without pressure");
  expect_stated(static_cast<double>(facts.duplicates), stated.duplicates, 0, "duplicates");
  expect_stated(static_cast<double>(facts.equal_stamps), stated.equal_stamps, 0, "equal stamps");
}

INSTANTIATE_TEST_SUITE_P(, PenFileFactsOfOthers, testing::ValuesIn(stated_facts),
                         [](const auto& one) { return test::test_name_of(one.param.file); });

TEST(PenFileFactsOfAll, AreComparedForEveryFile) {
  BURIN_SHARED_DATA_OR_SKIP(folder, std::string("strokes"));
  std::set<std::string> compared, there;
  for (const StatedFacts& one : stated_facts) compared.insert(one.file);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() != ".desc") there.insert(entry.path().filename().string());
  EXPECT_EQ(there, compared);
}

}  // namespace
}  // namespace burin
