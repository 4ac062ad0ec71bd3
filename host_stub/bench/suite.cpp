// Reads suites, which are JSON files of cases. Unknown keys, missing files and members that exclude each
// other are refused with the place of the fault.
#include "bench/suite.h"

#include <burin/base/text/json_value.h>
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/files/setting_values.h>

#include <iterator>
#include <set>
#include <string_view>

namespace burin {
namespace fs = std::filesystem;

namespace {

std::string existing_file(const JsonValue& value, const fs::path& folder) {
  const fs::path path = (folder / value.text()).lexically_normal();
  std::error_code error;
  if (!fs::is_regular_file(path, error)) value.reject("there is no file " + path.string());
  return path.string();
}

/// What `read` makes of the member of this name, if there is one.
template <class Target, class Read>
void read_if(const JsonValue& object, const std::string& name, Target& target, const Read& read) {
  if (const auto value = object.find(name)) target = read(*value);
}

double positive(const JsonValue& value) { return value.positive(); }

StraightStroke straight_stroke(const JsonValue& value) {
  constexpr std::string_view keys[] = {"samples", "from", "towards", "length_radii"};
  value.allow_only(keys);
  StraightStroke stroke{value.member("samples").whole(2, 1000000), read_point(value.member("from")),
                        read_point(value.member("towards")), value.member("length_radii").positive()};
  if (stroke.from == stroke.towards) value.reject("'from' and 'towards' are the same place");
  return stroke;
}

MeshOptions mesh(const JsonValue& value, const fs::path& folder) {
  MeshOptions options;
  options.path = existing_file(value.member("mesh"), folder);
  read_if(value, "subdivide", options.subdivide,
          [](const JsonValue& levels) { return static_cast<int>(levels.whole(0, 15)); });
  read_if(value, "target_triangles", options.target_triangles,
          [](const JsonValue& count) { return count.whole(1, std::uint64_t{1} << 30); });
  if (options.subdivide && options.target_triangles)
    value.reject("takes either 'subdivide' or 'target_triangles'");
  return options;
}

void read_strokes(const JsonValue& value, const fs::path& folder, BenchCase& into) {
  if (const auto files = value.find("strokes")) {
    for (const JsonValue& file : files->items()) into.strokes.push_back(existing_file(file, folder));
    if (into.strokes.empty()) files->reject("names no file");
  }
  read_if(value, "stroke", into.straight, straight_stroke);
  if (into.strokes.empty() == !into.straight) value.reject("takes either 'strokes' or 'stroke'");
  if (!into.straight) return;
  const AlongSettings* along = into.settings.find(&StrokeSettings::along);
  if (!into.settings.find(&StrokeSettings::brush) && !(along && along->given()))
    value.reject("lacks 'brush', which a made stroke needs");
  if (!into.settings.find(&StrokeSettings::radius) && !into.radius_edges)
    value.reject("lacks 'radius' or 'radius_edges', which a made stroke needs");
}

/// Those of a case besides the settings of strokes.
constexpr std::string_view case_keys[] = {
    "name", "mesh", "subdivide", "target_triangles", "strokes", "stroke", "radius_edges", "repeat", "axis"};

void allow_only_known(const JsonValue& value) {
  std::vector<std::string_view> keys(std::begin(case_keys), std::end(case_keys));
  for (const SettingRow& row : setting_table()) keys.push_back(row.key);
  value.allow_only(keys);
}

BenchCase read_case(const JsonValue& value, const fs::path& folder) {
  allow_only_known(value);
  BenchCase bench_case;
  bench_case.name = value.member("name").text();
  bench_case.mesh = mesh(value, folder);
  read_settings(value, SettingsOf::suite, bench_case.settings);
  read_if(value, "radius_edges", bench_case.radius_edges, positive);
  if (bench_case.radius_edges && bench_case.settings.find(&StrokeSettings::radius))
    value.reject("takes either 'radius' or 'radius_edges'");
  read_strokes(value, folder, bench_case);
  read_if(value, "repeat", bench_case.repeat, [](const JsonValue& count) { return count.whole(1, 1000); });
  read_if(value, "axis", bench_case.axis,
          [](const JsonValue& name) { return name.choice(scaling_axis_names()); });
  return bench_case;
}

}  // namespace

const std::map<std::string, ScalingAxis>& scaling_axis_names() {
  static const std::map<std::string, ScalingAxis> names = {
      {"none", ScalingAxis::none}, {"region", ScalingAxis::region}, {"mesh", ScalingAxis::mesh}};
  return names;
}

Suite read_suite(const fs::path& path) {
  const JsonValue file = JsonValue::read(path);
  constexpr std::string_view keys[] = {"burin_suite", "name", "cases"};
  file.allow_only(keys);
  file.member("burin_suite").whole(1, 1);
  Suite suite{path.string(), file.member("name").text(), {}};
  std::set<std::string> names;
  for (const JsonValue& item : file.member("cases").items()) {
    suite.cases.push_back(read_case(item, path.parent_path()));
    if (!names.insert(suite.cases.back().name).second)
      item.member("name").reject("is the name of an earlier case");
  }
  if (suite.cases.empty()) file.member("cases").reject("holds no case");
  return suite;
}

}  // namespace burin
