// Parses the lines of a `.stroke` file.
#include <burin/base/error.h>
#include <burin/base/quoted_word.h>
#include <burin/stroke/files/recording_faults.h>
#include <burin/stroke/files/stroke_lines.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace burin {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<std::string_view, Column>, 8> column_names{{{"time", Column::time},
                                                                           {"x", Column::x},
                                                                           {"y", Column::y},
                                                                           {"z", Column::z},
                                                                           {"pressure", Column::pressure},
                                                                           {"tilt_x", Column::tilt_x},
                                                                           {"tilt_y", Column::tilt_y},
                                                                           {"twist", Column::twist}}};

const Json& member(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw Error(fmt::format("{} is missing", name));
  return *found;
}

/// A JSON value as messages show it.
std::string word_of(const Json& value) {
  return quoted_word(value.is_string() ? value.get<std::string>() : value.dump());
}

double number(const Json& value, std::string_view name) {
  if (!value.is_number()) throw Error(fmt::format("{} must be a number", name));
  return value.get<double>();
}

std::vector<double> numbers(const Json& value, std::string_view name) {
  if (!value.is_array()) throw Error(fmt::format("{} must be a list of numbers", name));
  std::vector<double> all;
  for (const Json& element : value) all.push_back(number(element, fmt::format("each number of {}", name)));
  return all;
}

void expect_object(const Json& value, std::string_view name) {
  if (!value.is_object()) throw Error(fmt::format("{} must be an object", name));
}

void reject_fault(std::string_view fault) {
  if (!fault.empty()) throw Error(std::string(fault));
}

Mat4d parse_matrix(const Json& camera, const char* name) {
  const std::vector<double> elements = numbers(member(camera, name), name);
  if (elements.size() != 16)
    throw Error(fmt::format("{} has {} numbers, a matrix needs 16", name, elements.size()));
  return Eigen::Map<const Mat4d>(elements.data());  // both are column-major
}

int parse_extent(const Json& value) {
  if (!value.is_number_integer() || value < 1 || value > std::numeric_limits<int>::max())
    throw Error("viewport must be two whole numbers of pixels");
  return value.get<int>();
}

Camera parse_camera(const Json& value) {
  expect_object(value, "camera");
  Camera camera;
  camera.view = parse_matrix(value, "view");
  camera.projection = parse_matrix(value, "projection");
  const Json& viewport = member(value, "viewport");
  if (!viewport.is_array() || viewport.size() != 2)
    throw Error("viewport must be two whole numbers of pixels");
  camera.width = parse_extent(viewport[0]);
  camera.height = parse_extent(viewport[1]);
  reject_fault(fault_of(camera));
  return camera;
}

ParamSetting parse_param(const Json& value, const std::string& id) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  const std::string name = "parameter " + quoted_word(id);
  if (!value.is_array()) throw Error(name + " must be a truth value, number, text or list of numbers");
  return numbers(value, name);
}

Dynamic parse_dynamic(const Json& value) {
  expect_object(value, "each of dynamics");
  const Json &target = member(value, "target"), &source = member(value, "source");
  if (!target.is_string()) throw Error("a dynamic's target must be text");
  const auto known = source.is_string() ? source_named(source.get<std::string>()) : std::nullopt;
  if (!known)
    throw Error(fmt::format("a dynamic has no source {}; there are: {}", word_of(source), source_names()));
  return {target.get<std::string>(), *known, numbers(member(value, "curve"), "a dynamic's curve")};
}

RecordedStroke parse_settings(const Json& begin) {
  expect_object(begin, "begin");
  RecordedStroke stroke;
  if (begin.contains("brush")) {
    if (!begin["brush"].is_string()) throw Error("brush must be text");
    stroke.brush = begin["brush"].get<std::string>();
  }
  if (begin.contains("radius")) stroke.radius = number(begin["radius"], "radius");
  if (begin.contains("strength")) stroke.strength = number(begin["strength"], "strength");
  if (begin.contains("follow")) stroke.follow = number(begin["follow"], "follow");
  if (begin.contains("closed")) {
    if (!begin["closed"].is_boolean()) throw Error("closed must be true or false");
    stroke.closed = begin["closed"].get<bool>();
  }
  if (begin.contains("params")) {
    expect_object(begin["params"], "params");
    for (const auto& [id, value] : begin["params"].items()) stroke.params[id] = parse_param(value, id);
  }
  if (begin.contains("dynamics")) {
    if (!begin["dynamics"].is_array()) throw Error("dynamics must be a list");
    for (const Json& value : begin["dynamics"]) stroke.dynamics.push_back(parse_dynamic(value));
  }
  reject_fault(fault_of(stroke));
  return stroke;
}

Column column_named(const Json& name) {
  if (!name.is_string()) throw Error("fields must be a list of names");
  const auto& text = name.get_ref<const std::string&>();
  const auto found = std::find_if(column_names.begin(), column_names.end(),
                                  [&](const auto& known) { return known.first == text; });
  return found == column_names.end() ? Column::unknown : found->second;
}

bool has(const std::vector<Column>& columns, Column column) {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

std::vector<Column> parse_columns(const Json& fields, StrokeSpace space) {
  if (!fields.is_array()) throw Error("fields must be a list of names");
  std::vector<Column> columns;
  std::set<std::string> seen;
  for (const Json& name : fields) {
    columns.push_back(column_named(name));
    if (!seen.insert(name.get<std::string>()).second)
      throw Error(fmt::format("field {} is named twice", word_of(name)));
  }
  if (!has(columns, Column::x) || !has(columns, Column::y)) throw Error("fields lack x or y");
  if (space == StrokeSpace::object && !has(columns, Column::z))
    throw Error("fields lack z, which object space needs");
  return columns;
}

void set(Sample& sample, Column column, double value) {
  switch (column) {
    case Column::time:
      sample.time = value;
      break;
    case Column::x:
      sample.position.x() = value;
      break;
    case Column::y:
      sample.position.y() = value;
      break;
    case Column::z:
      sample.position.z() = value;
      break;
    case Column::pressure:
      sample.pen.pressure = static_cast<float>(value);
      break;
    case Column::tilt_x:
      sample.pen.tilt_x = static_cast<float>(value);
      break;
    case Column::tilt_y:
      sample.pen.tilt_y = static_cast<float>(value);
      break;
    case Column::twist:
      sample.pen.twist = static_cast<float>(value);
      break;
    case Column::unknown:
      break;
  }
}

}  // namespace

HeaderLine parse_header(const Json& line) {
  const Json& version = member(line, "burin_stroke");
  if (!version.is_number()) throw Error("burin_stroke must be the number of the format's version");
  if (version != 1)
    throw Error(fmt::format("version {} of the format is not known, only 1 is", version.dump()));
  HeaderLine header;
  const Json& space = member(line, "space");
  if (space != "object" && space != "screen") throw Error("space must be \"object\" or \"screen\"");
  if (space == "screen") header.space = StrokeSpace::screen;
  if (line.contains("camera")) header.camera = parse_camera(line["camera"]);
  if (header.space == StrokeSpace::screen && !header.camera)
    throw Error("camera is missing, which screen space needs");
  return header;
}

BeginLine parse_begin(const Json& line, StrokeSpace space) {
  BeginLine begin{parse_settings(member(line, "begin")), parse_columns(member(line, "fields"), space)};
  PenFields& fields = begin.stroke.fields;
  fields.time = has(begin.columns, Column::time);
  fields.pressure = has(begin.columns, Column::pressure);
  fields.tilt = has(begin.columns, Column::tilt_x) || has(begin.columns, Column::tilt_y);
  fields.twist = has(begin.columns, Column::twist);
  return begin;
}

Sample parse_sample(const Json& line, const std::vector<Column>& columns) {
  if (line.size() != columns.size())
    throw Error(fmt::format("the sample has {} values for {} fields", line.size(), columns.size()));
  Sample sample;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] != Column::unknown)
      set(sample, columns[i], number(line[i], fmt::format("value {} of the sample", i + 1)));
  reject_fault(fault_of(sample));
  return sample;
}

}  // namespace burin
