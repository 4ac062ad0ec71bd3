#pragma once
#include <burin/plugin/stroke.h>

#include <algorithm>
#include <cmath>

namespace burin::plugin {

/// Periods of equal length along a stroke, from its start on.
struct Periods {
  double length;  ///< of a period, object units
  double count;   ///< whole ones in the stroke; 0 when they go on however long it gets
};

/// Periods of about `length` (object units, > 0). On a closed stroke they are stretched so that a whole
/// number goes round, as they are on an open one with `fit`; on both the number is a multiple of `multiple`.
/// Whoever asks for a fit depends on the stroke's end: StrokeStart::end_influence is infinite.
inline Periods periods(const Stroke& stroke, double length, bool fit = false, double multiple = 1) {
  const bool whole = stroke.closed() || (fit && !stroke.dab());
  if (!whole || stroke.length() <= 0) return {length, 0};
  const double count = multiple * std::max(1.0, std::round(stroke.length() / (length * multiple)));
  return {stroke.length() / count, count};
}

/// Where on the drawn line t lies: a dab continues the line that it is a dab of.
inline double along_line(const Stroke& stroke, float t) { return stroke.dab_t() + t; }

}  // namespace burin::plugin
