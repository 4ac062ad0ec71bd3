#pragma once
#include <burin/math/elementary.h>

#include <cmath>
#include <numbers>

namespace burin {

/// What a step does to Fermi coordinates whose lines of constant d are circles around one centre, as they are
/// around a corner of the stroke and beside a bend of constant curvature; exact on the plane, and for k = 0.
struct CircleStep {
  float cosine, sine;  ///< of the angle by which the line of constant d has turned, left positive
  float along;         ///< arc length, on the line where the step began
  float across;        ///< change of d, the shorter way around the centre
  float size;          ///< of the circle after the step against that before it: J grows, and k shrinks by it
};

/// The step (u, v), ahead and to the left, from a line at the distance d whose curvature is k: u and v in
/// object units, k in their inverse. Where lines draw together toward a centre near by and farther from the
/// stroke, steps are straight: around a focal point distances told by circles would fall again, while the
/// true ones, of other parts of the stroke, rise.
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
  // The series of the arc tangent is as good as floats need it below this slope.
  constexpr float gentle = 0.2F;
  if (std::abs(ahead) <= gentle * inward) {
    const float slope = ahead / inward, slope2 = slope * slope;
    step.along = u / inward * (1 - slope2 * (1 / 3.F - slope2 * (1 / 5.F - slope2 / 7)));
  } else if (inward > 0) {
    step.along = static_cast<float>(math::atan2(double{ahead}, double{inward})) / k;
  } else {
    // Past the centre, where steps to the left and to the right have to go over into each other.
    step.along = std::numbers::pi_v<float> / 2 * step.sine / k;
  }
  return step;
}

}  // namespace burin
