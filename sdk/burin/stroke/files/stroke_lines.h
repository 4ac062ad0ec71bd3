#pragma once
#include <burin/stroke/recording.h>

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace burin {

// The kinds of line of a `.stroke` file, from JSON. All throw Error that says what is wrong.

struct HeaderLine {
  StrokeSpace space = StrokeSpace::object;
  std::optional<Camera> camera;
};
HeaderLine parse_header(const nlohmann::json& line);

/// Where a number of a sample goes.
enum class Column { unknown, time, x, y, z, pressure, tilt_x, tilt_y, twist };

struct BeginLine {
  RecordedStroke stroke;  ///< without samples
  std::vector<Column> columns;
};
BeginLine parse_begin(const nlohmann::json& line, StrokeSpace space);

Sample parse_sample(const nlohmann::json& line, const std::vector<Column>& columns);

}  // namespace burin
