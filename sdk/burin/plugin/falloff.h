#pragma once
#include <burin/plugin/stroke.h>

#include <algorithm>
#include <cmath>

// The functions may be called on any thread, also on several at once.
namespace burin::plugin {

/// A smooth step: 0 for x <= 0, 1 for x >= 1, and between them a cubic with zero slope at both ends.
inline float smooth_step(float x) { return burin_smooth_step(x); }

/// The height of a round strand or thread of half width 1 at distance x >= 0 from its middle: a circle up to
/// x = 0.9, then the tangent there, which falls below 0, so that strands have no vertical sides.
inline float strand_profile(float x) {
  return std::sqrt(1 - std::min(x * x, 0.81f)) - 2.0647416f * std::max(x - 0.9f, 0.0f);
}

/// A factor that fades out towards the rim: 0 at the rim and outside, 1 at least `rim` (a share of the
/// radius, > 0) inside it.
inline float rim_factor(const Stroke& stroke, float t, float d, float radius, float rim) {
  return burin_rim_factor(&stroke.raw(), t, d, radius, rim);
}

/// How far back from its end a stroke with this taper (radii) depends on its length, object units: what
/// StrokeStart::end_influence must be at least for taper_factor().
inline double taper_influence(const Stroke& stroke, float taper) {
  return burin_taper_influence(&stroke.raw(), taper);
}

/// A factor that fades out towards the ends of an open stroke: 0 at an end and beyond, 1 at least `taper`
/// radii inside. A stroke shorter than a radius fades out less, and a tap, whose length is 0, not at all.
/// `end_distance` is the input of this name.
inline float taper_factor(const Stroke& stroke, float end_distance, float radius, float taper) {
  return burin_taper_factor(&stroke.raw(), end_distance, radius, taper);
}

}  // namespace burin::plugin
