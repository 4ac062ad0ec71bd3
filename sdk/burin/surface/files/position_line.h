#pragma once
#include <burin/base/vector.h>

#include <string>
#include <string_view>

namespace burin {

/// Parses one coordinate of a vertex. Returns an error message, or an empty string if the word is a number in
/// the range of floats.
std::string read_coordinate(std::string_view word, double& coordinate);

/// Reads the three coordinates of a vertex and removes them from the front of a line. Returns an error
/// message, or an empty string if all are numbers in the range of floats.
std::string read_position(std::string_view& line, Vec3d& place);

}  // namespace burin
