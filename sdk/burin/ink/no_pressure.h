#pragma once
#include <burin/ink/pen_file.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace burin {

/// Takes the pressure of a stroke, a PenStroke or RecordedStroke, for absent.
template <class Stroke>
void leave_out_pressure(Stroke& stroke) {
  stroke.fields.pressure = false;
  for (Sample& sample : stroke.samples) sample.pen.pressure = Pen{}.pressure;
}

/// The greatest pressure of strokes if all are whole numbers, as those of a device in its own range are, and
/// marks of what a point is; nothing if one is not.
inline std::optional<float> greatest_whole_pressure(std::span<const PenStroke> strokes) {
  float most = 0;
  for (const PenStroke& stroke : strokes)
    for (const Sample& sample : stroke.samples) {
      if (sample.pen.pressure != std::floor(sample.pen.pressure)) return std::nullopt;
      most = std::max(most, sample.pen.pressure);
    }
  return most;
}

}  // namespace burin
