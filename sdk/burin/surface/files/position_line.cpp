// Parses three numbers, which must fit into floats.
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/position_line.h>
#include <burin/surface/files/text_lines.h>

#include <cmath>
#include <limits>

namespace burin {

std::string read_coordinate(std::string_view word, double& coordinate) {
  if (word.empty()) return "a vertex needs three coordinates";
  const auto value = real_number(word);
  if (!value) return quoted_word(word) + " is not a coordinate";
  if (!(std::abs(*value) <= std::numeric_limits<float>::max()))
    return "the coordinate " + quoted_word(word) + " is not finite";
  coordinate = *value;
  return {};
}

std::string read_position(std::string_view& line, Vec3d& place) {
  for (double& coordinate : place)
    if (std::string fault = read_coordinate(next_word(line), coordinate); !fault.empty()) return fault;
  return {};
}

}  // namespace burin
