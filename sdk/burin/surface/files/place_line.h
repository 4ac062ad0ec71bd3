#pragma once
#include <burin/base/vector.h>

#include <string>
#include <string_view>

namespace burin {

/// Takes the three coordinates of a vertex off the front of a line of text. Returns what is wrong with them;
/// empty: nothing, and all are in the range of floats.
std::string take_place(std::string_view& line, Vec3d& place);

}  // namespace burin
