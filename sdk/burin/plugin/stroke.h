#pragma once
#include <burin/abi/stroke.h>
#include <burin/math/elementary.h>
#include <burin/plugin/detail/complete.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin::plugin {

/// The stroke as a whole, as far as it is drawn.
class Stroke {
 public:
  explicit Stroke(const burin_stroke_context& context) : context_(complete(context)) {}

  double length() const { return context_.length; }          ///< so far, object units; 0 when it begins
  double radius_min() const { return context_.radius_min; }  ///< along the whole stroke, object units
  double radius_max() const { return context_.radius_max; }
  double object_scale() const { return context_.object_scale; }  ///< diagonal of the surface's bounding box
  std::uint64_t seed() const { return context_.seed; }           ///< key of random numbers
  std::uint32_t pass() const { return context_.pass; }  ///< of those that StrokeStart::passes asked for

  /// t lives modulo length: the stroke has no ends.
  bool closed() const { return context_.flags & BURIN_STROKE_CLOSED; }

  /// The pen is up: length will not change any more.
  bool finished() const { return context_.flags & BURIN_STROKE_FINAL; }

  /// A symmetry instance that is a mirror image: d, e2 and `across` point to the right of the travel.
  bool mirrored() const { return context_.flags & BURIN_STROKE_MIRRORED; }

  /// One dab of a stroke of dabs: length() is 0, t and d are normal coordinates around its middle.
  bool dab() const { return context_.flags & BURIN_STROKE_DAB; }

  /// Of a dab: arc length along the stroke at which it lies; else 0.
  double dab_t() const { return context_.dab_t; }

  /// Whether the stroke ends anywhere: closed ones and dabs do not.
  bool has_ends() const { return !closed() && !dab(); }

  /// Whether the recording really has this pen input (BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME); the others
  /// read as their neutral value.
  bool has_pen(std::uint64_t input) const { return context_.pen_present & input; }

  /// How far t lies beyond an end: below 0 before the start, above 0 after the end, else 0. With d it is the
  /// way from the stroke to the place (t, d).
  float beyond(float t) const {
    if (closed()) return 0;
    const float after = t - static_cast<float>(context_.length);
    return after > 0 ? after : std::min(t, 0.0f);
  }

  /// Distance to the stroke of the place (t, d): |d| beside it, round its ends within caps.
  float distance(float t, float d) const {
    const float along = beyond(t);
    return along != 0 ? math::hypot(along, d) : std::abs(d);
  }

  /// Arc length of t along the drawn line: a dab continues the pattern of the line that it is a dab of.
  double along_line(float t) const { return dab_t() + t; }

  /// The length next to `period` (object units, > 0) that goes a whole number of times around a closed
  /// stroke; on others `period` itself.
  double whole_period(double period) const {
    if (!closed() || !(length() > 0)) return period;
    return length() / std::max(1.0, std::round(length() / period));
  }

 private:
  burin_stroke_context context_;
};

}  // namespace burin::plugin
