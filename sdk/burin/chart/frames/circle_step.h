#pragma once
#include <burin/math/elementary.h>

#include <cmath>
#include <numbers>

namespace burin {

/// The change of Fermi coordinates by a step, when the lines of constant d are concentric circles, as they
/// are around a corner of the stroke and beside a bend of constant curvature. Exact on the plane, and for k =
/// 0.
struct CircleStep {
  float cosine, sine;  ///< cosine and sine of the angle by which the line of constant d turns, left positive
  float along;         ///< arc length along the line of constant d from which the step starts
  float across;        ///< change of d
  float size;          ///< radius of the circle after the step over that before it: J grows by it, k shrinks
};

/// Computes the step (u, v), ahead and to the left, from a line of constant d whose curvature is k; u, v and
/// d in object units, k in their inverse. When the centre lies farther from the stroke than the line, and
/// near compared with the step, the step is straight: beyond that focal point the circles' distance would
/// fall again, while the true distance, to other parts of the stroke, rises.
inline CircleStep circle_step(float u, float v, float k, float d) {
  constexpr float most_turn = 0.5F;
  const float squared = u * u + v * v;
  if (k * d > 0 && k * k * squared > most_turn * most_turn) return {1, 0, u, v, 1};
  const float ahead = k * u, inward = 1 - k * v;
  const float size = std::sqrt(ahead * ahead + inward * inward);
  CircleStep step{
      .cosine = 1, .sine = 0, .along = u, .across = (2 * v - k * squared) / (1 + size), .size = size};
  if (!(size > 0)) return step;
  step.cosine = inward / size;
  step.sine = ahead / size;
  // Below this slope the series of the arc tangent is exact to float precision.
  constexpr float gentle = 0.2F;
  if (std::abs(ahead) <= gentle * inward) {
    const float slope = ahead / inward, slope2 = slope * slope;
    step.along = u / inward * (1 - slope2 * (1 / 3.F - slope2 * (1 / 5.F - slope2 / 7)));
  } else if (inward > 0) {
    step.along = static_cast<float>(math::atan2(double{ahead}, double{inward})) / k;
  } else {
    // Past the centre the result must be continuous between steps to the left and steps to the right.
    step.along = std::numbers::pi_v<float> / 2 * step.sine / k;
  }
  return step;
}

}  // namespace burin
