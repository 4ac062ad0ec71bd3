// Draws recordings of real pens and programs on three surfaces: no sample gets lost, and strokes have neither
// tears nor holes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

const char* const recordings[] = {"bdalab_html5_pointer_signal.json",
                                  "bdalab_signal.svc",
                                  "evemu_cintiq_12wx.events",
                                  "evemu_intuos4_6x9_stylus_drag.events",
                                  "evemu_uclogic_wp5540u_pen.events",
                                  "excalidraw_biology.excalidrawlib.xz",
                                  "excalidraw_despair.excalidrawlib.xz",
                                  "excalidraw_handdrawn_signs.excalidrawlib",
                                  "hid_intuospro_m_eraser_ccw_circle.hid",
                                  "hid_intuospro_m_pen_strong_vertical.hid",
                                  "hid_intuospro_m_pen_two_horizontal.hid.xz",
                                  "inkml_inkmljs_ink1.inkml",
                                  "isf_bezier.isf",
                                  "isf_canvas_lasso_pressure.isf",
                                  "isf_gif.isf",
                                  "isf_initial_ink.isf",
                                  "isf_multi_stroke_gesture.isf",
                                  "painting30sec.dat",
                                  "perfect_freehand_test_inputs.json",
                                  "pointer_iink_diagram_1.json",
                                  "pointer_iink_hello.json",
                                  "rm_v5_empty_first_layer.rm",
                                  "rm_v5_six_pens.rm",
                                  "rm_v6_color_and_tool.rm",
                                  "rm_v6_lines.rm",
                                  "rm_v6_two_layers_points1.rm",
                                  "strokestrip_triceratops.scap",
                                  "tilt_perftest_simple.tilt",
                                  "tilt_toolkit_sketch1.tilt",
                                  "uim_30_digital_ink_is_processable.uim",
                                  "uim_31_digital_ink_is_processable.uim",
                                  "uim_31_math_structures.uim",
                                  "wacom_uim_digital_ink_is_processable.json",
                                  "will_apple.will",
                                  "will_elephant.will",
                                  "will_wine.will",
                                  "xopp_load_strokes.xopp",
                                  "xopp_xournal_stroke_line_return.xoj",
                                  "xopp_zip_stroke.xopp"};

struct Ground {
  const char* name;
  TriangleMesh (*make)();
};

TriangleMesh sheet(Vec3d (*at)(double u, double v)) {
  return patch({.u_min = -1, .u_max = 1, .v_min = -0.75, .v_max = 0.75, .cells_u = 200, .cells_v = 150}, at);
}

/// Hills with bumps of some edges, as a scan has them.
Vec3d bumpy(double u, double v) {
  const double hills = 0.12 * std::sin(5 * u + 1) * std::cos(4 * v);
  return {u, v, hills + 0.006 * std::sin(40 * u) * std::sin(37 * v + 9 * u) + 0.001 * std::sin(211 * u * v)};
}

const Ground grounds[] = {{"plane", [] { return sheet([](double u, double v) { return Vec3d(u, v, 0); }); }},
                          {"sphere", [] { return sphere(6, 0.2, 7); }},
                          {"scan", [] { return sheet(bumpy); }}};

using Case = std::tuple<const char*, Ground>;
class RealRecording : public testing::TestWithParam<Case> {};

std::string name_of_case(const testing::TestParamInfo<Case>& one) {
  return test_name_of(std::get<0>(one.param)) + "_" + std::get<1>(one.param).name;
}

/// Each recording on one of the grounds.
std::vector<Case> on_one_ground_each() {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < std::size(recordings); ++i)
    cases.emplace_back(recordings[i], grounds[i % std::size(grounds)]);
  return cases;
}

INSTANTIATE_TEST_SUITE_P(OnOneGroundEach, RealRecording, testing::ValuesIn(on_one_ground_each()),
                         name_of_case);

// Takes some minutes: --gtest_also_run_disabled_tests.
INSTANTIATE_TEST_SUITE_P(DISABLED_OnAllGrounds, RealRecording,
                         testing::Combine(testing::ValuesIn(recordings), testing::ValuesIn(grounds)),
                         name_of_case);

/// Strokes in space lie on both sides of a surface, and break where they cross it. Others never break, though
/// sketches of hundreds of strokes over each other make a steep relief.
void expect_no_tears(const std::string& name, int pieces, int strokes) {
  if (!name.ends_with(".tilt")) {
    EXPECT_EQ(pieces, strokes);
  }
}

TEST_P(RealRecording, IsDrawnWithoutALossOrAHole) {
  const auto [name, ground] = GetParam();
  BURIN_SHARED_DATA_OR_SKIP(recording, std::string("strokes/") + name);
  const CommandFolder folder;
  const std::string mesh = folder.write("ground.obj", obj_text(ground.make()));
  const std::string strokes = folder.path("a.stroke");
  const auto imported = nlohmann::json::parse(
      burin({"import", recording.string(), "--mesh", mesh, "--view", "0,0,-1", "--fit", "mesh", "--brush",
             "org.burin.groove", "--radius", "0.02", "--out", strokes, "--json"})
          .out);
  const auto drawn =
      nlohmann::json::parse(burin({"replay", strokes, "--mesh", mesh, "--refine", "off", "--json"}).out);
  EXPECT_EQ(drawn["strokes"], imported["strokes"]);
  EXPECT_EQ(drawn["events"].get<int>() + drawn["events_off_surface"].get<int>(), imported["samples"])
      << "every sample is on the surface or counted as off";
  EXPECT_EQ(drawn["events_off_surface"], 0);
  expect_no_tears(name, drawn["pieces"], drawn["strokes"]);
  const std::size_t count = std::min<std::size_t>(imported["strokes"].get<std::size_t>(), 3);
  for (std::size_t stroke = 1; stroke <= count; ++stroke) {
    const auto charted =
        burin_json({"chart", strokes, "--stroke", std::to_string(stroke), "--mesh", mesh, "--check"});
    EXPECT_EQ(charted["check"]["holes"], 0) << "stroke " << stroke;
  }
}

}  // namespace
}  // namespace burin::test
