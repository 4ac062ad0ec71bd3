#include "bench/suite.h"

#include <fmt/format.h>

#include <set>

#include "bench/json_value.h"
#include "options/stroke_choices.h"

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
double number(const JsonValue& value) { return value.number(); }
std::string text(const JsonValue& value) { return value.text(); }

Vec3d point(const JsonValue& value) {
  const std::vector<double> numbers = value.numbers();
  if (numbers.size() != 3) value.reject("must be three numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

ParamSetting param(const JsonValue& value) {
  if (value.is_boolean()) return value.boolean();
  if (value.is_text()) return value.text();
  if (value.is_array()) return value.numbers();
  return value.number();
}

ParamSettings params(const JsonValue& value) {
  ParamSettings settings;
  for (const auto& [name, setting] : value.members()) settings[name] = param(setting);
  return settings;
}

StraightStroke straight_stroke(const JsonValue& value) {
  value.allow_only({"samples", "from", "towards", "length_radii"});
  StraightStroke stroke{value.member("samples").whole(2, 1000000), point(value.member("from")),
                        point(value.member("towards")), value.member("length_radii").positive()};
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

StrokeOverrides overrides(const JsonValue& value) {
  StrokeOverrides overrides;
  read_if(value, "brush", overrides.brush, text);
  read_if(value, "radius", overrides.radius, positive);
  read_if(value, "strength", overrides.strength, number);
  read_if(value, "params", overrides.params, params);
  read_if(value, "overlap", overrides.overlap,
          [](const JsonValue& name) { return name.choice(overlap_names()); });
  read_if(value, "join", overrides.join, [](const JsonValue& name) { return name.choice(join_names()); });
  read_if(value, "closed", overrides.closure,
          [](const JsonValue& name) { return name.choice(closure_names()); });
  read_if(value, "pressure_width", overrides.pressure_width, [](const JsonValue& share) {
    if (!(share.number() >= 0 && share.number() <= 1)) share.reject("must be a number from 0 to 1");
    return share.number();
  });
  read_if(value, "show_every", overrides.show_every,
          [](const JsonValue& count) { return static_cast<std::size_t>(count.whole(0, 1000000)); });
  return overrides;
}

void read_strokes(const JsonValue& value, const fs::path& folder, BenchCase& into) {
  if (const auto files = value.find("strokes")) {
    for (const JsonValue& file : files->items()) into.strokes.push_back(existing_file(file, folder));
    if (into.strokes.empty()) files->reject("names no file");
  }
  read_if(value, "stroke", into.straight, straight_stroke);
  if (into.strokes.empty() == !into.straight) value.reject("takes either 'strokes' or 'stroke'");
  if (!into.straight) return;
  if (!into.overrides.brush) value.reject("lacks 'brush', which a made stroke needs");
  if (!into.overrides.radius && !into.radius_edges)
    value.reject("lacks 'radius' or 'radius_edges', which a made stroke needs");
}

BenchCase read_case(const JsonValue& value, const fs::path& folder) {
  value.allow_only({"name", "mesh", "subdivide", "target_triangles", "strokes", "stroke", "brush", "radius",
                    "radius_edges", "strength", "params", "overlap", "join", "closed", "pressure_width",
                    "show_every", "repeat", "axis"});
  BenchCase bench_case;
  bench_case.name = value.member("name").text();
  bench_case.mesh = mesh(value, folder);
  bench_case.overrides = overrides(value);
  read_if(value, "radius_edges", bench_case.radius_edges, positive);
  if (bench_case.radius_edges && bench_case.overrides.radius)
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
  file.allow_only({"burin_suite", "name", "cases"});
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
