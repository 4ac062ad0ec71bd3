// Parses the lines of a `.stroke` file.
#include <burin/base/text/quoted_word.h>
#include <burin/stroke/files/recording_faults.h>
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/files/stroke_lines.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace burin {
namespace {

constexpr std::array<std::pair<std::string_view, Column>, 9> column_names{{{"time", Column::time},
                                                                           {"x", Column::x},
                                                                           {"y", Column::y},
                                                                           {"z", Column::z},
                                                                           {"pressure", Column::pressure},
                                                                           {"tilt_x", Column::tilt_x},
                                                                           {"tilt_y", Column::tilt_y},
                                                                           {"twist", Column::twist},
                                                                           {"barrel", Column::barrel}}};

void reject_fault(const JsonValue& value, std::string_view fault) {
  if (!fault.empty()) value.reject(fault);
}

Mat4d parse_matrix(const JsonValue& value) {
  const std::vector<double> elements = value.numbers();
  if (elements.size() != 16) value.reject(fmt::format("has {} numbers, a matrix needs 16", elements.size()));
  return Eigen::Map<const Mat4d>(elements.data());  // both are column-major
}

int parse_extent(const JsonValue& value) {
  return static_cast<int>(value.whole(1, std::numeric_limits<int>::max()));
}

Camera parse_camera(const JsonValue& line) {
  const JsonValue value = line.member("camera");
  Camera camera;
  camera.view = parse_matrix(value.member("view"));
  camera.projection = parse_matrix(value.member("projection"));
  const JsonValue viewport = value.member("viewport");
  const std::vector<JsonValue> extents = viewport.items();
  if (extents.size() != 2) viewport.reject("must be two whole numbers of pixels");
  camera.width = parse_extent(extents[0]);
  camera.height = parse_extent(extents[1]);
  reject_fault(line, validation_error(camera));
  return camera;
}

Column column_named(std::string_view name) {
  const auto found = std::ranges::find(column_names, name, &std::pair<std::string_view, Column>::first);
  return found == column_names.end() ? Column::unknown : found->second;
}

bool has(const std::vector<Column>& columns, Column column) {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

std::vector<Column> parse_columns(const JsonValue& fields, StrokeSpace space) {
  std::vector<Column> columns;
  std::set<std::string> seen;
  for (const JsonValue& field : fields.items()) {
    columns.push_back(column_named(field.text()));
    if (!seen.insert(field.text()).second)
      fields.reject(fmt::format("name {} twice", quoted_word(field.text())));
  }
  if (!has(columns, Column::x) || !has(columns, Column::y)) fields.reject("lack x or y");
  if (space == StrokeSpace::object && !has(columns, Column::z))
    fields.reject("lack z, which object space needs");
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
    case Column::barrel:
      sample.barrel = value != 0;
      break;
    case Column::unknown:
      break;
  }
}

bool boolean_of(const JsonValue& value) {
  if (!value.is_boolean()) value.reject_type("true or false");
  return value.boolean();
}

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Removes a number of JSON from the front of a text. Takes no other writings of numbers, which
/// std::from_chars() knows too; returns false for these and for numbers out of range.
bool take_json_number(std::string_view& text, double& value) {
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const bool zero_before = digits.starts_with('0') && digits.size() > 1 && is_digit(digits[1]);
  if (digits.empty() || !is_digit(digits.front()) || zero_before) return false;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  const auto size = static_cast<std::size_t>(stop - text.data());
  const std::size_t point = text.substr(0, size).find('.');
  if (point != text.npos && (point + 1 == size || !is_digit(text[point + 1]))) return false;
  text.remove_prefix(size);
  return true;
}

}  // namespace

HeaderLine parse_header(const JsonValue& line) {
  const JsonValue version = line.member("burin_stroke");
  if (const double number = version.number(); number != 1)
    version.reject(fmt::format("version {} of the format is not known, only 1 is", number));
  static const std::map<std::string, StrokeSpace> spaces = {{"object", StrokeSpace::object},
                                                            {"screen", StrokeSpace::screen}};
  HeaderLine header;
  header.space = line.member("space").choice(spaces);
  if (line.find("camera")) header.camera = parse_camera(line);
  if (const auto device = line.find("device")) header.device = device->text();
  if (header.space == StrokeSpace::screen && !header.camera)
    line.reject("lacks 'camera', which screen space needs");
  return header;
}

BeginLine parse_begin(const JsonValue& line, StrokeSpace space) {
  BeginLine begin;
  read_settings(line.member("begin"), SettingsOf::recording, begin.stroke.settings);
  begin.columns = parse_columns(line.member("fields"), space);
  PenFields& fields = begin.stroke.fields;
  fields.time = has(begin.columns, Column::time);
  fields.pressure = has(begin.columns, Column::pressure);
  fields.tilt = has(begin.columns, Column::tilt_x) || has(begin.columns, Column::tilt_y);
  fields.twist = has(begin.columns, Column::twist);
  fields.barrel = has(begin.columns, Column::barrel);
  if (const auto eraser = line.find("eraser")) begin.stroke.drawn_by.eraser = boolean_of(*eraser);
  if (const auto tool = line.find("tool")) begin.stroke.drawn_by.tool = tool->text();
  return begin;
}

Sample parse_sample(const JsonValue& line, const std::vector<Column>& columns) {
  if (line.size() != columns.size())
    line.reject(fmt::format("the sample has {} values for {} fields", line.size(), columns.size()));
  Sample sample;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] != Column::unknown) set(sample, columns[i], line.number_at(i));
  reject_fault(line, validation_error(sample));
  return sample;
}

std::optional<Sample> plain_sample(std::string_view line, const std::vector<Column>& columns) {
  Sample sample;
  char before = '[';
  for (const Column column : columns) {
    double value = 0;
    if (!line.starts_with(before)) return std::nullopt;
    line.remove_prefix(1);
    if (!take_json_number(line, value)) return std::nullopt;
    if (column != Column::unknown) set(sample, column, value);
    before = ',';
  }
  return line == "]" && validation_error(sample).empty() ? std::optional(sample) : std::nullopt;
}

}  // namespace burin
