#include <gtest/gtest.h>

#include <algorithm>

#include "run_command.h"
#include "support/point_shapes.h"

namespace burin::test {
namespace {

/// A folder with good and bad files, by their names.
void fill(const CommandFolder& folder) {
  const std::string sphere_text = obj_text(sphere(2, 0, 1));
  const std::string good = "\"brush\":\"org.burin.groove\",\"radius\":0.3";
  const std::string stroke = equator_stroke(-0.5, 0.5, 21, good);
  folder.write("sphere.obj", sphere_text);
  folder.write("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  folder.write("empty.obj", "");
  folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  folder.write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n");
  folder.write(
      "mask.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float mask\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1\n1 0 0 2\n0 1 0 1\n3 0 1 2\n");
  folder.write(
      "values.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float height\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1\n1 0 0 nan\n0 1 0 1\n3 0 1 2\n");
  folder.write("mesh.xyz", "0 0 0\n");
  folder.write("points.ply", ply_text(sphere_points(3, 1)));
  folder.write(
      "no_normals.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n");
  folder.write(
      "zero_normal.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "end_header\n0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n");
  folder.write("three_quads.obj",
               "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nv 0 1 0\nv 0 1 1\nv -1 0 0\nv -1 0 1\n"
               "f 1 2 4 3\nf 1 2 6 5\nf 1 2 8 7\n");
  folder.write("cube.obj", cube_obj());
  folder.write("tile.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 0\nvt 2 0\nvt 1 1\nf 1/1 2/2 3/3\n");
  folder.write("nan_uv.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt nan 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
  folder.write("good.stroke", stroke);
  folder.write("off.stroke",
               "{\"burin_stroke\":1,\"space\":\"object\"}\n{\"begin\":{\"radius\":0.3},\"fields\":[\"x\","
               "\"y\",\"z\"]}\n"
               "[5,0,0]\n[5,0.1,0]\n{\"end\":true}\n");
  folder.write("empty.stroke", "");
  folder.write("header_only.stroke", "{\"burin_stroke\":1,\"space\":\"object\"}\n");
  folder.write("no_header.stroke", equator_stroke_lines(-0.5, 0.5, 21, good));
  folder.write("garbage.stroke", stroke.substr(0, stroke.find("[0.05")) + "[0.05,what\n[0.06,0,0,1]\n");
  folder.write("arity.stroke", stroke.substr(0, stroke.find("[0.05")) + "[0.05,0,1]\n[0.06,0,0,1]\n");
  folder.write("nan.stroke", stroke.substr(0, stroke.find("[0.05")) + "[0.05,NaN,0,1]\n[0.06,0,0,1]\n");
  folder.write("back.stroke", stroke.substr(0, stroke.find("[0.05")) + "[0.01,0,0,1]\n[0.06,0,0,1]\n");
  folder.write("unknown_brush.stroke",
               equator_stroke(-0.5, 0.5, 21, "\"brush\":\"org.none\",\"radius\":0.3"));
  folder.write("bad_follow.stroke", equator_stroke(-0.5, 0.5, 21, good + ",\"follow\":1.5"));
  folder.write("no_brush.stroke", equator_stroke(-0.5, 0.5, 21, "\"radius\":0.3"));
  folder.write("no_radius.stroke", equator_stroke(-0.5, 0.5, 21, "\"brush\":\"org.burin.groove\""));
  folder.write("bad_param.stroke", equator_stroke(-0.5, 0.5, 21, good + ",\"params\":{\"depth\":\"deep\"}"));
  folder.write(
      "bad_source.stroke",
      equator_stroke(-0.5, 0.5, 21,
                     good + ",\"dynamics\":[{\"target\":\"depth\",\"source\":\"wheel\",\"curve\":[0,1]}]"));
  folder.write(
      "bad_target.stroke",
      equator_stroke(-0.5, 0.5, 21,
                     good + ",\"dynamics\":[{\"target\":\"taper\",\"source\":\"t\",\"curve\":[0,1]}]"));
  folder.write("events.svc", "2\n0 0 0 1 0 900 0.5\n1 1 1 1 0 901 0.5\n");
  folder.write("events.dat", "0.0 1 1 0.5\n0.1 2 x 0.5\n");
  folder.write("events.json", "{\"x\":[1,2,3],\"y\":[1,2]}");
  std::filesystem::create_directory(folder.path("folder"));
}

struct BadInput {
  std::string name;
  std::vector<std::string> arguments;  // "@NAME" stands for a file of the folder
  std::string culprit;                 // what the line must name; "@" likewise
};

void PrintTo(const BadInput& input, std::ostream* out) { *out << input.name; }

class BadInputs : public ::testing::TestWithParam<BadInput> {};

std::string resolved(const CommandFolder& folder, const std::string& text) {
  return !text.empty() && text[0] == '@' ? folder.path(text.substr(1)) : text;
}

TEST_P(BadInputs, GiveOneLineAndNoFile) {
  const CommandFolder folder;
  fill(folder);
  const auto before = folder.content();
  std::vector<std::string> arguments;
  for (const std::string& argument : GetParam().arguments) arguments.push_back(resolved(folder, argument));
  const ProcessResult result = burin(arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("burin: ", 0), 0u) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_NE(result.err.find(resolved(folder, GetParam().culprit)), std::string::npos) << result.err;
  EXPECT_EQ(folder.content(), before);
}

std::vector<std::string> replay(const std::string& stroke, const std::string& mesh,
                                const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"replay",      stroke,       "--mesh",   mesh,
                                        "--save-mesh", "@saved.ply", "--report", "@report"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

std::vector<std::string> chart(const std::string& stroke, const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"chart", stroke, "--mesh", "@sphere.obj"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

std::vector<std::string> snap(const std::string& stroke, const std::string& mesh, const std::string& feature,
                              const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"snap",      stroke,  "--mesh", mesh,
                                        "--feature", feature, "--out",  "@out.stroke"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

std::vector<BadInput> snaps() {
  return {
      {"snap_off_the_surface", snap("@off.stroke", "@sphere.obj", "ridge"),
       "@off.stroke: stroke 1 does not meet the surface"},
      {"snap_of_points", snap("@good.stroke", "@points.ply", "ridge"), "@points.ply: holds points"},
      {"snap_to_a_missing_value", snap("@good.stroke", "@values.ply", "scalar:heat"),
       "@values.ply: its vertices have no value 'heat', only 'x', 'y', 'z', 'height'"},
      {"snap_to_a_value_that_is_no_number", snap("@good.stroke", "@values.ply", "scalar:height"),
       "@values.ply: vertex 2: is not finite"},
      {"snap_to_a_value_of_obj", snap("@good.stroke", "@sphere.obj", "scalar:heat"),
       "@sphere.obj: only PLY files"},
      {"snap_to_a_value_of_a_cage",
       snap("@good.stroke", "@values.ply", "scalar:height", {"--subdivide", "1"}), "--feature"},
      {"snap_to_no_feature", snap("@good.stroke", "@sphere.obj", "crest"), "'crest'"},
      {"snap_to_creases_of_no_angle", snap("@good.stroke", "@sphere.obj", "crease:sharp"), "'crease:sharp'"},
      {"snap_to_creases_of_180_degrees", snap("@good.stroke", "@sphere.obj", "crease:180"), "'crease:180'"},
      {"snap_without_radius", snap("@no_radius.stroke", "@sphere.obj", "ridge"), "@no_radius.stroke"},
      {"snap_without_view", snap("@good.stroke", "@sphere.obj", "silhouette"), "@good.stroke"},
      {"snap_by_no_camera",
       snap("@good.stroke", "@sphere.obj", "silhouette", {"--camera", "@no_radius.stroke"}),
       "@no_radius.stroke: holds no camera"},
      {"snap_by_two_views",
       snap("@good.stroke", "@sphere.obj", "silhouette",
            {"--camera", "@no_radius.stroke", "--view", "0,0,-1"}),
       "--camera"},
      {"snap_scale_of_zero", snap("@good.stroke", "@sphere.obj", "ridge", {"--scale", "0"}), "--scale"},
      {"snap_without_folder",
       {"snap", "@good.stroke", "--mesh", "@sphere.obj", "--feature", "ridge", "--out", "@none/a.stroke"},
       "@none/a.stroke"}};
}

std::vector<BadInput> meshes() {
  return {
      {"missing_mesh", replay("@good.stroke", "@none.obj"), "@none.obj"},
      {"folder_as_mesh", replay("@good.stroke", "@folder"), "@folder"},
      {"index_out_of_range", replay("@good.stroke", "@cut.obj"), "@cut.obj"},
      {"empty_mesh", replay("@good.stroke", "@empty.obj"), "@empty.obj"},
      {"mesh_without_area", replay("@good.stroke", "@flat.obj"), "@flat.obj"},
      {"truncated_ply", replay("@good.stroke", "@cut.ply"), "@cut.ply"},
      {"mask_out_of_range", replay("@good.stroke", "@mask.ply"), "@mask.ply:vertex 2: its mask is 2"},
      {"unknown_format", replay("@good.stroke", "@mesh.xyz"), "@mesh.xyz"},
      {"non_manifold_cage", replay("@good.stroke", "@three_quads.obj", {"--subdivide", "1"}),
       "@three_quads.obj"},
      {"loop_of_quads", replay("@good.stroke", "@cube.obj", {"--subdivide", "1", "--scheme", "loop"}),
       "@cube.obj"},
      {"sculpt_level_above_the_finest",
       replay("@good.stroke", "@cube.obj", {"--subdivide", "2", "--sculpt-level", "3"}), "@cube.obj"},
      {"map_without_texture_coordinates", replay("@good.stroke", "@cube.obj", {"--bake", "@map.exr"}),
       "@cube.obj: not every face has texture coordinates"},
      {"map_of_another_tile", replay("@good.stroke", "@tile.obj", {"--bake", "@map.exr"}),
       "@tile.obj: face 1 lies around (1.33333, 0.333333)"},
      {"map_of_no_numbers", replay("@good.stroke", "@nan_uv.obj", {"--bake", "@map.exr"}),
       "@nan_uv.obj: face 1 has texture coordinates that are no numbers"},
      {"map_of_another_format", replay("@good.stroke", "@cube.obj", {"--bake", "@map.png"}), "@map.png"},
      {"map_in_no_folder", replay("@good.stroke", "@cube.obj", {"--bake", "@none/map.exr"}), "@none/map.exr"},
      {"map_of_no_size", replay("@good.stroke", "@cube.obj", {"--bake", "@map.exr", "--bake-size", "0"}),
       "--bake-size"},
      {"map_size_without_map", replay("@good.stroke", "@cube.obj", {"--bake-size", "64"}), "--bake"},
      {"too_many_triangles", replay("@good.stroke", "@cube.obj", {"--subdivide", "15"}),
       "@cube.obj: level 15 of this cage has 12884901888 triangles"},
      {"negative_weld", replay("@good.stroke", "@cube.obj", {"--weld", "-1"}), "--weld"}};
}

std::vector<BadInput> strokes() {
  const auto draw = [](const std::string& stroke) { return replay(stroke, "@sphere.obj"); };
  return {{"missing_stroke", draw("@none.stroke"), "@none.stroke"},
          {"folder_as_stroke", draw("@folder"), "@folder"},
          {"empty_stroke", draw("@empty.stroke"), "@empty.stroke"},
          {"header_only", draw("@header_only.stroke"), "@header_only.stroke"},
          {"no_header", draw("@no_header.stroke"), "@no_header.stroke:1"},
          {"garbage_line", draw("@garbage.stroke"), "@garbage.stroke:8"},
          {"wrong_arity", draw("@arity.stroke"), "@arity.stroke:8"},
          {"not_a_number", draw("@nan.stroke"), "@nan.stroke:8"},
          {"time_falls", draw("@back.stroke"), "@back.stroke:8"},
          {"unknown_brush", draw("@unknown_brush.stroke"), "@unknown_brush.stroke"},
          {"no_brush", draw("@no_brush.stroke"), "@no_brush.stroke"},
          {"no_radius", draw("@no_radius.stroke"), "@no_radius.stroke"},
          {"unknown_recorded_source", draw("@bad_source.stroke"), "@bad_source.stroke:2"},
          {"recorded_follow_beyond_one", draw("@bad_follow.stroke"), "@bad_follow.stroke:2"},
          {"recorded_dynamic_of_a_constant", draw("@bad_target.stroke"), "@bad_target.stroke: stroke 1"},
          {"recorded_param_of_wrong_type", draw("@bad_param.stroke"), "@bad_param.stroke"}};
}

std::vector<BadInput> settings() {
  const auto draw = [](const std::vector<std::string>& options) {
    return replay("@good.stroke", "@sphere.obj", options);
  };
  return {{"unknown_brush_option", draw({"--brush", "org.none"}), "org.none"},
          {"unknown_param", draw({"--param", "colour=1"}), "colour"},
          {"param_out_of_range", draw({"--param", "depth=1000"}), "depth"},
          {"param_of_wrong_type", draw({"--param", "depth=deep"}), "depth"},
          {"param_without_value", draw({"--param", "depth"}), "--param"},
          {"negative_radius", draw({"--radius", "-1"}), "--radius"},
          {"radius_nan", draw({"--radius", "nan"}), "--radius"},
          {"strength_infinite", draw({"--strength", "inf"}), "--strength"},
          {"follow_beyond_one", draw({"--follow", "1.5"}), "--follow"},
          {"follow_nan", draw({"--follow", "nan"}), "--follow"},
          {"pressure_width_nan", draw({"--pressure-width", "nan"}), "--pressure-width"},
          {"dynamic_of_nothing", draw({"--dynamic", "dept=pressure:0,0,1,1"}), "'dept'"},
          {"dynamic_of_a_constant", draw({"--dynamic", "taper=pressure:0,0,1,1"}), "'taper'"},
          {"dynamic_of_a_choice", draw({"--dynamic", "profile=pressure:0,0,1,1"}), "'profile'"},
          {"unknown_source", draw({"--dynamic", "depth=wheel:0,0,1,1"}), "'wheel'"},
          {"dynamic_without_source", draw({"--dynamic", "depth=0,0,1,1"}), "--dynamic"},
          {"dynamic_without_target", draw({"--dynamic", "=t:0,0,1,1"}), "--dynamic"},
          {"dynamic_without_curve", draw({"--dynamic", "depth=pressure:"}), "--dynamic"},
          {"dynamic_of_half_a_knot", draw({"--dynamic", "depth=pressure:0,0,1"}), "pairs"},
          {"dynamic_that_does_not_rise", draw({"--dynamic", "depth=pressure:1,0,0,1"}), "rise"},
          {"unknown_stabiliser", draw({"--stabilise", "rope:1"}), "--stabilise"},
          {"stabiliser_without_length", draw({"--stabilise", "string"}), "--stabilise"},
          {"stabiliser_of_no_length", draw({"--stabilise", "string:0"}), "--stabilise"},
          {"two_levels", draw({"--subdivide", "1", "--target-triangles", "100"}), "--subdivide"},
          {"unknown_scheme", draw({"--subdivide", "1", "--scheme", "doo-sabin"}), "--scheme"},
          {"unknown_option", draw({"--colour", "red"}), "--colour"}};
}

std::vector<BadInput> outputs() {
  return {{"save_mesh_without_folder",
           {"replay", "@good.stroke", "--mesh", "@sphere.obj", "--save-mesh", "@none/out.ply"},
           "@none/out.ply"},
          {"save_mesh_is_a_folder",
           {"replay", "@good.stroke", "--mesh", "@sphere.obj", "--save-mesh", "@folder"},
           "@folder"},
          {"save_mesh_of_another_format",
           {"replay", "@good.stroke", "--mesh", "@sphere.obj", "--save-mesh", "@out.stl"},
           "@out.stl"},
          {"report_is_a_file",
           {"replay", "@good.stroke", "--mesh", "@sphere.obj", "--report", "@sphere.obj"},
           "@sphere.obj"},
          {"chart_csv_without_folder", chart("@good.stroke", {"--png", "@a.png", "--csv", "@none/a.csv"}),
           "@none/a.csv"},
          {"chart_png_without_folder", chart("@good.stroke", {"--csv", "@a.csv", "--png", "@none/a.png"}),
           "@none/a.png"},
          {"render_png_without_folder",
           {"render", "--mesh", "@sphere.obj", "--png", "@none/a.png"},
           "@none/a.png"},
          {"import_without_folder",
           {"import", "@events.dat", "--mesh", "@sphere.obj", "--out", "@none/a.stroke"},
           "@none/a.stroke"}};
}

std::vector<BadInput> other_commands() {
  return {
      {"nothing", {}, "subcommand"},
      {"unknown_command", {"paint"}, "paint"},
      {"chart_without_radius", chart("@no_radius.stroke", {"--csv", "@a.csv"}), "@no_radius.stroke"},
      {"chart_of_no_stroke", chart("@good.stroke", {"--stroke", "2", "--csv", "@a.csv"}), "@good.stroke"},
      {"chart_off_the_surface", chart("@off.stroke", {"--csv", "@a.csv"}), "@off.stroke"},
      {"render_missing_mesh", {"render", "--mesh", "@none.obj", "--png", "@a.png"}, "@none.obj"},
      {"render_without_png", {"render", "--mesh", "@sphere.obj"}, "--png"},
      {"view_of_two_numbers",
       {"render", "--mesh", "@sphere.obj", "--png", "@a.png", "--view", "1,2"},
       "--view"},
      {"view_of_zeros", {"render", "--mesh", "@sphere.obj", "--png", "@a.png", "--view", "0,0,0"}, "--view"},
      {"missing_recording",
       {"import", "@none.dat", "--mesh", "@sphere.obj", "--out", "@a.stroke"},
       "@none.dat"},
      {"malformed_events",
       {"import", "@events.dat", "--mesh", "@sphere.obj", "--out", "@a.stroke"},
       "@events.dat:2"},
      {"malformed_svc",
       {"import", "@events.svc", "--mesh", "@sphere.obj", "--out", "@a.stroke"},
       "@events.svc:3"},
      {"malformed_pointer_events",
       {"import", "@events.json", "--mesh", "@sphere.obj", "--out", "@a.stroke"},
       "@events.json"}};
}

std::vector<BadInput> point_sets() {
  const auto chart_of = [](const std::string& mesh, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"chart", "@good.stroke", "--mesh", mesh, "--csv", "@a.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  };
  return {{"replay_on_points", replay("@good.stroke", "@points.ply"), "@points.ply"},
          {"render_points", {"render", "--mesh", "@points.ply", "--png", "@a.png"}, "points without faces"},
          {"import_onto_points",
           {"import", "@events.dat", "--mesh", "@points.ply", "--out", "@a.stroke"},
           "points without faces"},
          {"picture_of_points", chart_of("@points.ply", {"--png", "@a.png"}), "--png"},
          {"refined_points", chart_of("@points.ply", {"--subdivide", "1"}), "@points.ply"},
          {"points_without_normals", chart_of("@no_normals.ply", {}), "has no normals: properties 'nx'"},
          {"points_with_a_zero_normal", chart_of("@zero_normal.ply", {}),
           "@zero_normal.ply: the normal of point 2"}};
}

std::string test_name(const ::testing::TestParamInfo<BadInput>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Meshes, BadInputs, ::testing::ValuesIn(meshes()), test_name);
INSTANTIATE_TEST_SUITE_P(Snaps, BadInputs, ::testing::ValuesIn(snaps()), test_name);
INSTANTIATE_TEST_SUITE_P(Strokes, BadInputs, ::testing::ValuesIn(strokes()), test_name);
INSTANTIATE_TEST_SUITE_P(Settings, BadInputs, ::testing::ValuesIn(settings()), test_name);
INSTANTIATE_TEST_SUITE_P(Outputs, BadInputs, ::testing::ValuesIn(outputs()), test_name);
INSTANTIATE_TEST_SUITE_P(PointSets, BadInputs, ::testing::ValuesIn(point_sets()), test_name);
INSTANTIATE_TEST_SUITE_P(OtherCommands, BadInputs, ::testing::ValuesIn(other_commands()), test_name);

TEST(Help, ExplainsEveryCommand) {
  for (const char* command : {"replay", "chart", "render", "list", "import", "snap"}) {
    EXPECT_NE(burin_output({"--help"}).find(command), std::string::npos);
    EXPECT_NE(burin_output({command, "--help"}).find("--json"), std::string::npos);
  }
}

TEST(BadInput, HasItsWordsCutAndItsControlCharactersShown) {
  const CommandFolder folder;
  fill(folder);
  for (const std::string& word : {std::string("\x1b[2J"), std::string(250000, 'w')}) {
    const nlohmann::json quoted = word;
    const std::string text = quoted.dump();
    const std::string mesh = folder.path("sphere.obj"), radius = "\"radius\":0.3,";
    const auto stroke = [&](const std::string& settings) {
      return std::vector<std::string>{
          "replay", folder.write("words.stroke", equator_stroke(-0.5, 0.5, 21, settings)), "--mesh", mesh};
    };
    const std::string groove = radius + "\"brush\":\"org.burin.groove\"";
    const std::string suite =
        folder.write("words.json", "{\"burin_suite\":1,\"name\":\"n\",\"cases\":[]," + text + ":1}");
    const auto expect_short_line = [&](const std::vector<std::string>& command) {
      const ProcessResult result = burin(command);
      EXPECT_EQ(result.exit_code, 2);
      EXPECT_LT(result.err.size(), 1000u) << result.err.substr(0, 500);
      EXPECT_EQ(result.err.find('\x1b'), result.err.npos);
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err.substr(0, 500);
    };
    for (const std::string& settings :
         {radius + "\"brush\":" + text, groove + ",\"params\":{" + text + ":1}",
          groove + ",\"params\":{\"profile\":" + text + "}",
          groove + ",\"dynamics\":[{\"target\":" + text + ",\"source\":\"t\",\"curve\":[0,0]}]"})
      expect_short_line(stroke(settings));
    expect_short_line({"bench", suite});
    if (word.size() > 100) continue;  // more than the system takes as an argument
    expect_short_line({"replay", folder.path("good.stroke"), "--mesh", mesh, "--param", word});
    expect_short_line({"stamp", word});
    expect_short_line({word});
  }
}

TEST(BadInput, IsNotReadForEver) {
  const CommandFolder folder;
  fill(folder);
  for (const char* device : {"/dev/zero", "/dev/urandom"}) {
    if (!std::filesystem::exists(device)) continue;
    for (const auto& command : std::vector<std::vector<std::string>>{
             {"replay", device, "--mesh", folder.path("sphere.obj")},
             {"bench", device},
             {"stamp", device},
             {"import", device, "--format", "pointer", "--mesh", folder.path("sphere.obj"), "--out",
              folder.path("out.stroke")},
             {"import", device, "--format", "svc", "--mesh", folder.path("sphere.obj"), "--out",
              folder.path("out.stroke")}}) {
      const ProcessResult result = burin(command);
      EXPECT_EQ(result.exit_code, 2);
      EXPECT_TRUE(result.err == "burin: " + std::string(device) + ": is a device, not a file\n" ||
                  result.err == "burin: " + std::string(device) + ": is not a file\n")
          << result.err;
    }
  }
}

}  // namespace
}  // namespace burin::test
