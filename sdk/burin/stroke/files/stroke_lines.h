#pragma once
#include <burin/base/text/json_value.h>
#include <burin/stroke/recording.h>

#include <optional>
#include <string_view>
#include <vector>

namespace burin {

// Parsers of the kinds of line of a `.stroke` file. All throw FileError, which names the place of the fault.

struct HeaderLine {
  StrokeSpace space = StrokeSpace::object;
  std::optional<Camera> camera;
  std::string device;
};
HeaderLine parse_header(const JsonValue& line);

/// The member of Sample that a number of a sample line belongs to.
enum class Column { unknown, time, x, y, z, pressure, tilt_x, tilt_y, twist, barrel };

struct BeginLine {
  RecordedStroke stroke;  ///< without samples
  std::vector<Column> columns;
};
BeginLine parse_begin(const JsonValue& line, StrokeSpace space);

Sample parse_sample(const JsonValue& line, const std::vector<Column>& columns);

/// The same of the text of a line that is a sample as the writer has it, at a tenth of the cost. Nothing for
/// other lines and for faults.
std::optional<Sample> plain_sample(std::string_view line, const std::vector<Column>& columns);

}  // namespace burin
