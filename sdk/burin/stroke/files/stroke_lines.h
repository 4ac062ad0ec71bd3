#pragma once
#include <burin/stroke/recording.h>

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace burin {

// Parsers of the kinds of line of a `.stroke` file. All throw Error whose text says what is wrong.

struct HeaderLine {
  StrokeSpace space = StrokeSpace::object;
  std::optional<Camera> camera;
};
HeaderLine parse_header(const nlohmann::json& line);

/// The member of Sample that a number of a sample line belongs to.
enum class Column { unknown, time, x, y, z, pressure, tilt_x, tilt_y, twist };

struct BeginLine {
  RecordedStroke stroke;  ///< without samples
  std::vector<Column> columns;
};
BeginLine parse_begin(const nlohmann::json& line, StrokeSpace space);

Sample parse_sample(const nlohmann::json& line, const std::vector<Column>& columns);

}  // namespace burin
