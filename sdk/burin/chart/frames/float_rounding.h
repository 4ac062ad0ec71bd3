#pragma once
#include <limits>

namespace burin {

/// What sums and differences of a few floats of this size may be off by. Lengths below it mean nothing.
inline float float_rounding(float size) { return 4 * std::numeric_limits<float>::epsilon() * size; }

}  // namespace burin
