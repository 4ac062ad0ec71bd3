#pragma once
#include <burin/chart/joins/joins.h>
#include <burin/deform/overlap.h>
#include <burin/stroke/curve/surface_curve.h>

#include <map>
#include <string>

namespace burin {

// The names of stroke settings in command lines and suites.

const std::map<std::string, Closure>& closure_names();
const std::map<std::string, Join>& join_names();
const std::map<std::string, Overlap>& overlap_names();

}  // namespace burin
