// Writes a `.stroke` file line by line.
#include <burin/base/error.h>
#include <burin/stroke/files/recording_faults.h>
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/stroke_file.h>
#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

Json matrix_json(const Mat4d& matrix) {
  return std::vector<double>(matrix.data(), matrix.data() + 16);  // both are column-major
}

Json camera_json(const Camera& camera) {
  return {{"view", matrix_json(camera.view)},
          {"projection", matrix_json(camera.projection)},
          {"viewport", {camera.width, camera.height}}};
}

/// ContractError for what the reader would refuse.
Json settings_json(const GivenSettings& given) {
  Json settings = Json::object();
  try {
    write_settings(given, settings);
  } catch (const FileError& error) {
    throw ContractError(fmt::format("stroke file: {}", error.what()));
  }
  return settings;
}

std::vector<std::string> field_names(const RecordedStroke& stroke, StrokeSpace space) {
  const PenFields& fields = stroke.fields;
  std::vector<std::string> names;
  if (fields.time) names.insert(names.end(), {"time"});
  names.insert(names.end(), {"x", "y"});
  if (space == StrokeSpace::object) names.insert(names.end(), {"z"});
  if (fields.pressure) names.insert(names.end(), {"pressure"});
  if (fields.tilt) names.insert(names.end(), {"tilt_x", "tilt_y"});
  if (fields.twist) names.insert(names.end(), {"twist"});
  if (fields.barrel) names.insert(names.end(), {"barrel"});
  return names;
}

/// The line as JSON text. Throws ContractError for a text that is not UTF-8.
std::string dump(const Json& line) {
  try {
    return line.dump();
  } catch (const Json::type_error&) {
    throw ContractError("stroke file: a text is not valid UTF-8");
  }
}

/// Appends the shortest text that is read back as the same double. "-0" would be read back as the integer 0.
void append(std::string& line, double value) {
  if (value == 0 && std::signbit(value))
    line += "-0.0,";
  else
    fmt::format_to(std::back_inserter(line), "{},", value);
}

/// Appends the shortest text of a float. Read as a double and rounded, it gives that float again: all floats
/// were tried. The one exception, 7.0385307e-26, is among the small values that are written as doubles.
void append(std::string& line, float value) {
  if (std::abs(value) < 1e-20f) return append(line, static_cast<double>(value));
  fmt::format_to(std::back_inserter(line), "{},", value);
}

void expect_no_fault(std::string_view fault) {
  if (!fault.empty()) throw ContractError(fmt::format("stroke file: {}", fault));
}

}  // namespace

GivenSettings recorded_settings(const GivenSettings& given) {
  GivenSettings recorded;
  read_settings(JsonValue::of(settings_json(given), "settings"), SettingsOf::recording, recorded);
  return recorded;
}

StrokeWriter::StrokeWriter(const std::filesystem::path& path, StrokeSpace space,
                           const std::optional<Camera>& camera, std::string_view device, PassLines pass_lines)
    : path_(path), space_(space), pass_lines_(pass_lines) {
  if (space == StrokeSpace::screen && !camera)
    throw ContractError("stroke file: screen space needs a camera");
  if (camera) expect_no_fault(validation_error(*camera));
  Json header = {{"burin_stroke", 1}, {"space", space == StrokeSpace::screen ? "screen" : "object"}};
  if (camera) header["camera"] = camera_json(*camera);
  if (!device.empty()) header["device"] = device;
  std::string line = dump(header);
  out_.open(path, std::ios::binary | std::ios::trunc);
  if (!out_) throw FileError(path_.string(), std::strerror(errno));
  write_line(std::move(line));
}

void StrokeWriter::begin(const RecordedStroke& stroke) {
  if (open_) throw ContractError("stroke file: begin within a stroke");
  Json line = {{"begin", settings_json(stroke.settings)}, {"fields", field_names(stroke, space_)}};
  if (!stroke.drawn_by.tool.empty()) line["tool"] = stroke.drawn_by.tool;
  if (stroke.drawn_by.eraser) line["eraser"] = true;
  write_line(dump(line));
  fields_ = stroke.fields;
  last_time_ = -std::numeric_limits<double>::infinity();
  open_ = true;
}

void StrokeWriter::add(const Sample& sample) {
  if (!open_) throw ContractError("stroke file: a sample outside a stroke");
  expect_no_fault(validation_error(sample));
  if (fields_.time && sample.time < last_time_) throw ContractError("stroke file: time falls");
  std::string line = "[";
  if (fields_.time) append(line, sample.time);
  append(line, sample.position.x());
  append(line, sample.position.y());
  if (space_ == StrokeSpace::object) append(line, sample.position.z());
  if (fields_.pressure) append(line, sample.pen.pressure);
  if (fields_.tilt) {
    append(line, sample.pen.tilt_x);
    append(line, sample.pen.tilt_y);
  }
  if (fields_.twist) append(line, sample.pen.twist);
  if (fields_.barrel) line += sample.barrel ? "1," : "0,";
  line.back() = ']';
  write_line(std::move(line));
  last_time_ = sample.time;
}

void StrokeWriter::end() {
  if (!open_) throw ContractError("stroke file: an end outside a stroke");
  write_line(dump({{"end", true}}));
  open_ = false;
}

/// Where each line is passed at once, it is by one write and one flush, so that the system usually gets it
/// whole or not at all.
void StrokeWriter::write_line(std::string line) {
  line += '\n';
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  if (pass_lines_ == PassLines::at_once) return flush();
  if (!out_) throw FileError(path_.string(), "writing failed");
}

void StrokeWriter::flush() {
  out_.flush();
  if (!out_) throw FileError(path_.string(), "writing failed");
}

}  // namespace burin
