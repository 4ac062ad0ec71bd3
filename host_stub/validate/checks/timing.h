#pragma once
#include "validate/probe/stroke.h"

namespace burin::validate {

/// Time of evaluate in one batch, the least of some runs, nanoseconds per node.
double evaluate_time(const ProbeStroke& stroke, const Nodes& nodes, int runs);

/// The same of copying the inputs that a brush declares.
double copy_time(const burin_brush_descriptor& brush, const Nodes& nodes, int runs);

}  // namespace burin::validate
