// Every setting of strokes is the same on the command line, in suites, in recordings and in documents: what
// the table of settings says.
#include <burin/base/file.h>
#include <burin/stroke/files/setting_table.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "host_stub/bench/bench_suite.h"
#include "host_stub/input/brush_folder.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

using nlohmann::json;

/// A value of a setting, as JSON and as the words of the command line, and what it needs besides to be seen.
struct Example {
  json value;
  std::vector<std::string> typed;
  json besides = json::object();
  std::vector<std::string> besides_typed = {};
  bool draws_the_same = false;  ///< as without it
};

/// A mesh to bend along strokes.
const std::string& wedge() {
  static const CommandFolder folder;
  static const std::string path =
      folder.write("wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  return path;
}

/// An example of what wants a mesh along the stroke, of which a few copies do.
Example along(const json& value, const std::string& typed) {
  return {value,
          {typed},
          {{"along_mesh", wedge()}, {"along_spacing", 3}},
          {"--along-mesh", wedge(), "--along-spacing", "3"}};
}

const std::map<std::string, Example>& examples() {
  static const std::map<std::string, Example> all = {
      {"brush", {"org.burin.bead", {"org.burin.bead"}}},
      {"radius", {0.2, {"0.2"}}},
      {"strength", {-0.5, {"-0.5"}}},
      {"params", {{{"depth", 0.4}, {"width", 0.6}}, {"depth=0.4", "--param", "width=0.6"}}},
      {"dynamics",
       {json::array({{{"target", "strength"}, {"source", "t"}, {"curve", {0, 0, 4, 1}}},
                     {{"target", "depth"}, {"source", "pressure"}, {"curve", {0, 0.5, 1, 1}}}}),
        {"strength=t:0,0,4,1", "--dynamic", "depth=pressure:0,0.5,1,1"}}},
      // Wide strokes: narrow ones feel every bump of so coarse a mesh, which has no room for noise either.
      {"follow", {0.75, {"0.75"}, {{"radius", 0.8}}, {"--radius", "0.8"}}},
      {"pressure_width", {0.5, {"0.5"}}},
      {"closed", {"yes", {"yes"}}},
      {"cap",
       {"butt",
        {"butt"},
        {{"brush", "org.burin.bark"}, {"radius", 0.8}},
        {"--brush", "org.burin.bark", "--radius", "0.8"}}},
      {"join", {"overlap", {"overlap"}}},
      {"overlap", {"add", {"add"}}},
      {"accumulate", {"current", {"current"}}},
      {"clamp", {true, {}, {{"strength", 9}}, {"--strength", "9"}}},
      {"dabs", {0.5, {"0.5"}}},
      {"refine", {"edge:0.05", {"edge:0.05"}}},
      {"solid", {"none", {"none"}, {{"brush", "org.burin.tube"}}, {"--brush", "org.burin.tube"}}},
      {"voxel", {0.02, {"0.02"}, {{"brush", "org.burin.tube"}}, {"--brush", "org.burin.tube"}}},
      {"blend",
       {0.03,
        {"0.03"},
        {{"brush", "org.burin.tube"}, {"solid", "union"}, {"voxel", 0.02}, {"params", {{"height", 0}}}},
        {"--brush", "org.burin.tube", "--solid", "union", "--voxel", "0.02", "--param", "height=0"}}},
      {"along_mesh", {wedge(), {wedge()}}},
      {"along_start", along(wedge(), wedge())},
      {"along_end", along(wedge(), wedge())},
      {"along_axes", along("-z,y", "-z,y")},
      {"along_spacing", {3, {"3"}, {{"along_mesh", wedge()}}, {"--along-mesh", wedge()}}},
      {"along_twist", along(-0.5, "-0.5")},
      {"along_height", along(0.25, "0.25")},
      {"mirror", {"xz", {"xz"}}},
      {"radial", {3, {"3"}}},
      {"radial_axis", {"z", {"z"}, {{"radial", 3}}, {"--radial", "3"}}},
      {"symmetry_centre", {{0.1, 0, -0.2}, {"0.1,0,-0.2"}, {{"mirror", "x"}}, {"--mirror", "x"}}},
      {"stabilise", {"string:0.1", {"string:0.1"}}},
      {"show_every", {5, {"5"}, json::object(), {}, true}}};
  return all;
}

/// A stroke on the unit sphere with a bend sharper than its radius, which crosses itself; with pressure.
std::string crossing_stroke(const json& settings) {
  json begin = {{"brush", "org.burin.groove"}, {"radius", 0.25}};
  begin.update(settings);
  std::string text =
      fmt::format("{}\n{}\n", R"({"burin_stroke":1,"space":"object"})",
                  json{{"begin", begin}, {"fields", {"time", "x", "y", "z", "pressure"}}}.dump());
  const std::array<Vec3d, 4> corners{Vec3d(0, 0, 1), Vec3d(0.8, 0, 1), Vec3d(0.2, 0.5, 1),
                                     Vec3d(0.4, -0.4, 1)};
  for (int i = 0; i <= 60; ++i) {
    const auto leg = static_cast<std::size_t>(std::min(i / 20, 2));
    const double share = i / 20. - static_cast<double>(leg);
    const Vec3d at = ((1 - share) * corners[leg] + share * corners[leg + 1]).normalized();
    text += fmt::format("[{},{},{},{},{}]\n", 0.01 * i, at.x(), at.y(), at.z(), 0.3 + 0.01 * i);
  }
  return text + "{\"end\":true}\n";
}

/// A unit sphere with bumps, whose strokes feel them only where they follow.
TriangleMesh bumpy_sphere() {
  TriangleMesh mesh = sphere(4, 0.1, 1);
  for (Vec3f& p : mesh.positions) p *= 1 + 0.01f * std::sin(40 * p.x());
  return mesh;
}

struct Settings : CommandFolder {
  std::string mesh = write("sphere.obj", obj_text(bumpy_sphere()));

  /// What `replay` draws with these settings of the recording and these options.
  std::string replayed(const json& recorded, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"replay", write("a.stroke", crossing_stroke(recorded)), "--mesh", mesh});
    return burin_json(options)["result_hash"];
  }

  std::string write_suite(const json& settings) const {
    json one = {{"name", "a"}, {"mesh", "sphere.obj"}, {"strokes", {"a.stroke"}}, {"repeat", 1}};
    one.update(settings);
    return write("suite.json", json{{"burin_suite", 1}, {"name", "s"}, {"cases", {one}}}.dump());
  }

  /// What `bench` draws.
  std::string benched(const json& settings) const {
    write("a.stroke", crossing_stroke(json::object()));
    return burin_json({"bench", write_suite(settings), "--case", "a"})["cases"][0]["hash"];
  }

  void expect_same_everywhere(const SettingRow& row, const Example& example, const std::string& plain) const {
    std::vector<std::string> options = example.besides_typed;
    const std::string without = options.empty() ? plain : replayed(json::object(), options);
    options.push_back(row.option);
    options.insert(options.end(), example.typed.begin(), example.typed.end());
    const std::string typed = replayed(json::object(), options);
    EXPECT_EQ(without == typed, example.draws_the_same);
    json settings = example.besides;
    settings[row.key] = example.value;
    EXPECT_EQ(benched(settings), typed);
    if (row.recorded) {
      EXPECT_EQ(replayed(settings), typed);
    }
  }
};

TEST(Settings, DrawTheSameFromTheCommandLineASuiteAndARecording) {
  const Settings in;
  const std::string plain = in.replayed(json::object());
  json not_recorded;
  for (const SettingRow& row : setting_table()) {
    SCOPED_TRACE(row.key);
    ASSERT_TRUE(examples().contains(row.key)) << "needs an example here";
    in.expect_same_everywhere(row, examples().at(row.key), plain);
    if (!row.recorded) not_recorded[row.key] = examples().at(row.key).value;
  }
  EXPECT_EQ(in.replayed(not_recorded), plain) << "recordings pass over them";
}

TEST(Settings, AreRefusedAtTheirPlaceEverywhere) {
  const Settings in;
  for (const SettingRow& row : setting_table()) {
    const std::string suite = in.write_suite({{row.key, nullptr}});
    in.write("a.stroke", crossing_stroke(json::object()));
    EXPECT_EQ(
        burin({"bench", suite}).err.rfind(fmt::format("burin: {}: cases[0].{}: must be ", suite, row.key), 0),
        0u)
        << row.key;
    if (!row.recorded) continue;
    const std::string stroke = in.write("b.stroke", crossing_stroke({{row.key, nullptr}}));
    const ProcessResult result = burin({"replay", stroke, "--mesh", in.mesh});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err.rfind(fmt::format("burin: {}:2: begin.{}: must be ", stroke, row.key), 0), 0u)
        << result.err;
  }
}

TEST(Settings, AreRefusedByTheirOption) {
  const Settings in;
  const std::string stroke = in.write("a.stroke", crossing_stroke(json::object()));
  for (const SettingRow& row : setting_table()) {
    if (row.form == SettingForm::flag || row.key == "brush" || row.typed == "FILE")
      continue;  // takes any text, or none
    const ProcessResult result = burin(
        {"replay", stroke, "--mesh", in.mesh, row.option, "?", "--radial", "2", "--along-mesh", wedge()});
    EXPECT_EQ(result.exit_code, 2) << row.option;
    EXPECT_EQ(result.err.rfind("burin: " + row.option + ": ", 0), 0u) << result.err;
  }
}

TEST(Settings, StandInTheHelpOfReplay) {
  const std::string help = burin_output({"replay", "--help"});
  for (const SettingRow& row : setting_table()) {
    // Replays take modules, too.
    const bool brush = row.key == "brush";
    const std::string typed(brush ? "BRUSH" : row.typed), text(brush ? named_brushes_help : row.help);
    EXPECT_NE(help.find(fmt::format("  {} {}", row.option, typed)), std::string::npos) << row.option;
    EXPECT_NE(help.find(text), std::string::npos) << text;
  }
}

std::string values_of(const SettingRow& row) {
  return row.values + (row.unit.empty() ? "" : ", " + row.unit);
}

std::string table_of_suites() {
  std::string text = "| key | `replay` | | values, unit | default |\n| --- | --- | --- | --- | --- |\n";
  for (const SettingRow& row : setting_table()) {
    std::string initial = row.recorded ? "as recorded" : row.initial;
    if (row.recorded && !row.initial.empty()) initial += ", or " + row.initial;
    text += fmt::format("| `{}` | `{}` | {} | {} | {} |\n", row.key, row.option, row.help, values_of(row),
                        initial);
  }
  return text;
}

std::string table_of_recordings() {
  std::string text = "| key | | values, unit | absent |\n| --- | --- | --- | --- |\n";
  for (const SettingRow& row : setting_table())
    if (row.recorded)
      text += fmt::format("| `{}` | {} | {} | {} |\n", row.key, row.help, values_of(row),
                          row.initial.empty() ? "none" : row.initial);
  return text;
}

/// The tables of documents are those that the rows make.
TEST(Settings, StandInTheDocuments) {
  const std::filesystem::path docs = std::filesystem::path(BURIN_SOURCE_FOLDER) / "docs";
  const std::pair<const char*, std::string> tables[] = {{"bench.md", table_of_suites()},
                                                        {"stroke_format.md", table_of_recordings()}};
  for (const auto& [page, table] : tables)
    EXPECT_NE(read_file(docs / page).find("\n\n" + table + "\n"), std::string::npos)
        << page << " lacks this table:\n"
        << table;
}

}  // namespace
}  // namespace burin::test
