#pragma once
#include <burin/math/elementary.h>

namespace burin::plugin {

/// Elementary functions such as math::sin(). A brush that uses them instead of those of <cmath> gives the
/// same bits on every processor.
namespace math = burin::math;

}  // namespace burin::plugin
