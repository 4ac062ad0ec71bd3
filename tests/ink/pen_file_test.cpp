// Compares what is read of real files with what ../shared/data/SOURCES.md states of them.
#include <algorithm>
#include <limits>
#include <set>

#include "ink/pen_files.h"

namespace burin {
namespace {

constexpr double none = -1;

/// What is stated of a file. Ranges are of samples in contact, in the units that the reader gives.
struct Stated : test::StatedCounts {
  double seconds = none;  ///< from the first sample to the last
  double least_pressure = none, most_pressure = none;
  double least_tilt_x = none, most_tilt_x = none;  ///< degrees
  double least_tilt_y = none, most_tilt_y = none;
};

const Stated stated[] = {
    {"evemu_cintiq_12wx.events", "evemu", "mm", 241, 2, 113, 128, none, 99. / 1023, 765. / 1023, -32, 0, 0,
     41},
    {"evemu_intuos4_6x9_stylus_drag.events", "evemu", "", 295, 1, 295, 295, 1.47, 222. / 2047, 1, 14, 26, -14,
     -11},
    {"evemu_uclogic_wp5540u_pen.events", "evemu", "mm", 459, 1, 459, 459, none, 21. / 1023, 451. / 1023},
    {"evemu_genius_i405x_hover.events", "evemu", "", 0, 0, 0, 0},
    {"hid_intuospro_m_pen_strong_vertical.hid", "hid", "mm", 281, 1, 281, 281, none, 1040. / 8191, 1, 27, 35,
     0, 10},
    {"hid_intuospro_m_eraser_ccw_circle.hid", "hid", "mm", 399, 1, 399, 399, none, 284. / 8191, 7323. / 8191,
     27, 37, 4, 24},
    {"hid_intuospro_m_pen_two_horizontal.hid.xz", "hid", "mm", 391, 2, 183, 208, none, 1040. / 8191, 1, 19,
     34, 3, 11},
    {"pointer_iink_diagram_1.json", "pointers", "px", 910, 46, 1, 111, none, 0.5, 0.827},
    {"pointer_iink_hello.json", "pointers", "px", 422, 10, 3, 101, none, 0.52, 1},
    {"inkml_inkmljs_ink1.inkml", "inkml", "mm", 623, 13, 9, 164, none, 1. / 32767, 20262. / 32767},
    {"xopp_load_strokes.xopp", "xournal", "pt", 1698, 12, 2, 672},
    {"xopp_zip_stroke.xopp", "xournal", "pt", 90, 1, 90, 90},
    {"xopp_xournal_stroke_line_return.xoj", "xournal", "pt", 51, 1, 51, 51},
};

void expect_range(const test::Range& range, double least, double most, double tolerance) {
  if (least == none && most == none) {
    EXPECT_GT(range.least, range.most) << "the file has none";
    return;
  }
  EXPECT_NEAR(range.least, least, tolerance);
  EXPECT_NEAR(range.most, most, tolerance);
}

class PenFileOfOthers : public testing::TestWithParam<Stated> {};

TEST_P(PenFileOfOthers, HasWhatIsStatedOfIt) {
  const Stated& expected = GetParam();
  const std::string name = std::string("strokes/") + expected.file;
  BURIN_SHARED_DATA_OR_SKIP(path, name);
  const PenFile file = read_pen_file(path);
  ASSERT_NO_FATAL_FAILURE(test::expect_counts(file, expected));
  if (file.strokes.empty()) return;
  constexpr double degree = 3.14159265358979 / 180;
  expect_range(test::range_of(file, &PenFields::pressure, [](const Sample& s) { return s.pen.pressure; }),
               expected.least_pressure, expected.most_pressure, 5e-4);
  expect_range(test::range_of(file, &PenFields::tilt, [&](const Sample& s) { return s.pen.tilt_x / degree; }),
               expected.least_tilt_x, expected.most_tilt_x, 0.5);
  expect_range(test::range_of(file, &PenFields::tilt, [&](const Sample& s) { return s.pen.tilt_y / degree; }),
               expected.least_tilt_y, expected.most_tilt_y, 0.5);
  if (expected.seconds == none) return;
  const test::Range times = test::range_of(file, &PenFields::time, [](const Sample& s) { return s.time; });
  EXPECT_NEAR(times.most - times.least, expected.seconds, 0.01);
}

INSTANTIATE_TEST_SUITE_P(, PenFileOfOthers, testing::ValuesIn(stated),
                         [](const auto& one) { return test::test_name_of(one.param.file); });

const PenFile& only(const std::optional<std::filesystem::path>& path) {
  static PenFile file;
  return file = read_pen_file(*path);
}

TEST(PenFileOfOthersInDetail, HasTheQuirksThatAreStated) {
  const auto path = [](const std::string& name) { return test::shared_data("strokes/" + name); };
  if (!path("evemu_cintiq_12wx.events")) GTEST_SKIP() << "../shared/data/strokes is not on this machine";
  const PenFile& cintiq = only(path("evemu_cintiq_12wx.events"));
  EXPECT_FALSE(cintiq.strokes.at(0).drawn_by.eraser);
  EXPECT_TRUE(cintiq.strokes.at(1).drawn_by.eraser);
  EXPECT_EQ(cintiq.hovering, 362u - 241u);
  EXPECT_EQ(only(path("evemu_genius_i405x_hover.events")).hovering, 1112u);
  EXPECT_EQ(only(path("evemu_intuos4_6x9_stylus_drag.events")).hovering, 361u - 295u);
  EXPECT_EQ(only(path("evemu_uclogic_wp5540u_pen.events")).hovering, 506u - 459u);
  EXPECT_EQ(only(path("hid_intuospro_m_pen_strong_vertical.hid")).hovering, 368u - 281u);
  const PenFile& circle = only(path("hid_intuospro_m_eraser_ccw_circle.hid"));
  EXPECT_TRUE(circle.strokes.at(0).drawn_by.eraser);
  EXPECT_EQ(circle.hovering, 480u - 399u);
  test::Range x, y;
  for (const Sample& sample : circle.strokes[0].samples) {
    x.extend(sample.position.x());
    y.extend(sample.position.y());
  }
  EXPECT_GT(x.least, 0);
  EXPECT_LT(x.most, 224);
  EXPECT_LT(y.most, 148);
  EXPECT_GT(y.most - y.least, 20) << "millimetres";
  EXPECT_TRUE(only(path("pointer_iink_hello.json")).strokes.at(0).made_pressure);
  const PenFile& xopp = only(path("xopp_load_strokes.xopp"));
  const auto varies = [](const PenStroke& stroke) {
    return std::set<float>(stroke.widths.begin(), stroke.widths.end()).size() > 1;
  };
  EXPECT_EQ(std::ranges::count_if(xopp.strokes, varies), 2);
}

TEST(PenFile, NamesWhatIsKnownForWhatIsNot) {
  const test::PenFileFolder folder;
  EXPECT_EQ(
      folder.complaint("nothing that anybody knows\n"),
      " no pen file that is known; known are Universal Ink Model, Universal Ink Model in JSON, WILL, Tilt "
      "Brush, Ink Serialized Format, reMarkable lines, Excalidraw, scap drawings, InkML, Xournal and "
      "Xournal++, SVG paths, EVEMU recordings, hid-recorder, libinput record, lists of pointers from the "
      "web, Blender's brush strokes, PointerEvent arrays, SVC, libmypaint events, named lists of points, CSV "
      "with "
      "named columns");
  EXPECT_NE(folder.complaint(""), "accepted");
}

TEST(PenFile, RefusesTimesBeforeItsClockBegan) {
  const test::PenFileFolder folder;
  EXPECT_EQ(folder.complaint(R"([{"pointers":[{"x":1,"y":2,"t":0},{"x":1,"y":2,"t":-1}]}])"),
            " stroke 1, sample 2: time is negative");
  EXPECT_EQ(folder.complaint("x,y,time\n1,2,-1\n"), "accepted") << "a clock that began whenever it did";
}

// Packed bytes may have what a kind begins with.
TEST(PenFile, IsNotReadByPiecesWherePackedOrInUtf16) {
  const test::PenFileFolder folder;
  const std::string lines = "\nR: 1 05\nN: A\n" + std::string(100, ' ');
  const PenFilePieces small = {.head = 32, .block = 8};
  EXPECT_NE(open_pen_file(folder.write("a", "#" + lines), small).rest_at, 0u);
  EXPECT_EQ(open_pen_file(folder.write("b", "\xff\xfe" + lines), small).rest_at, 0u);
  EXPECT_EQ(open_pen_file(folder.write("c", "\x1f\x8b" + lines), small).rest_at, 0u);
}

TEST(PenFile, IsKnownByItsFirstBytesWhateverItsName) {
  const test::PenFileFolder folder;
  EXPECT_EQ(read_pen_file(folder.write("a.svg", "x,y\n1,2\n")).kind, "csv");
  EXPECT_EQ(read_pen_file(folder.write("a.csv", "<ink><trace>1 2</trace></ink>")).kind, "inkml");
  EXPECT_EQ(kind_of_pen_file(open_pen_file(folder.write("a", "x\ty\n"))), "csv");
  EXPECT_EQ(kind_of_pen_file(open_pen_file(folder.write("b", "0.1 2 3 0.5\n"))), "mypaint");
  EXPECT_EQ(kind_of_pen_file(open_pen_file(folder.write("c", "1\n1 2 0 1 0 900 1\n"))), "svc");
  EXPECT_EQ(kind_of_pen_file(open_pen_file(folder.write("d", "{\"time\": [1]}"))), "pointer");
  EXPECT_EQ(kind_of_pen_file(open_pen_file(folder.write("e", "0.1 2 3\n"))), "");
}

}  // namespace
}  // namespace burin
