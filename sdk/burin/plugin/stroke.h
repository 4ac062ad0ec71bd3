#pragma once
#include <burin/abi/stroke.h>
#include <burin/plugin/c/stroke_shape.h>
#include <burin/plugin/detail/complete.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace burin::plugin {

/// The stroke as a whole, as far as it has been drawn.
class Stroke {
 public:
  explicit Stroke(const burin_stroke_context& context) : context_(complete(context)) {}

  double length() const { return context_.length; }          ///< arc length so far, object units
  double radius_min() const { return context_.radius_min; }  ///< bound over the whole stroke, object units
  double radius_max() const { return context_.radius_max; }  ///< bound over the whole stroke, object units
  double object_scale() const { return context_.object_scale; }  ///< diagonal of the surface's bounding box
  std::uint64_t seed() const { return context_.seed; }           ///< key of random numbers
  std::uint32_t pass() const { return context_.pass; }  ///< number of the pass, 0 .. StrokeStart::passes - 1

  /// Whether the stroke is closed: t is periodic in length.
  bool closed() const { return context_.flags & BURIN_STROKE_CLOSED; }

  /// Whether the piece has ended, so that length does not change any more; always true for dabs.
  bool finished() const { return context_.flags & BURIN_STROKE_FINAL; }

  /// Whether this is a mirror image, in which d, e2 and `across` point to the right of the direction of
  /// travel.
  bool mirrored() const { return context_.flags & BURIN_STROKE_MIRRORED; }

  /// Whether this is one dab of a stroke of dabs. Then length() is 0, and t and d are geodesic normal
  /// coordinates around its middle.
  bool dab() const { return context_.flags & BURIN_STROKE_DAB; }

  /// For a dab its arc length along the stroke, object units; else 0.
  double dab_t() const { return context_.dab_t; }

  /// Whether the stroke has ends: closed strokes and dabs have none.
  bool has_ends() const { return burin_has_ends(&context_) != 0; }

  /// Whether the pen reports this input (BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME). Inputs that it does not
  /// report have their neutral value.
  bool has_pen(std::uint64_t input) const { return context_.pen_present & input; }

  /// How far t is beyond an end: negative before the start, positive after the end, else 0. Together with d
  /// it is the offset of the point (t, d) from the stroke.
  float beyond(float t) const { return burin_beyond_ends(&context_, t); }

  /// The distance of the point (t, d) to the stroke: |d| beside it, the distance to the end in the caps.
  float distance(float t, float d) const { return burin_distance(&context_, t, d); }

  /// The context of the call, for the functions of stroke_shape.h.
  const burin_stroke_context& raw() const { return context_; }

  /// How far t is past the nearer end: below 0 between the ends, -infinity where there are none.
  float past_ends(float t) const {
    if (!has_ends()) return -std::numeric_limits<float>::infinity();
    return std::max(-t, t - static_cast<float>(context_.length));
  }

  /// The arc length along the drawn line, also for dabs, so that they can continue a pattern along the line.
  double along_line(float t) const { return dab_t() + t; }

  /// The length nearest to `period` (object units, > 0) that divides the length of a closed stroke; on other
  /// strokes `period` itself.
  double whole_period(double period) const { return burin_whole_period(&context_, period); }

  /// The offset along t from the nearest of marks that are `period` apart (object units, > 0). The first mark
  /// of an open stroke is at its start, the last one at or before its end, so StrokeStart::end_influence must
  /// be half a period at least.
  float from_mark(float t, double period) const { return burin_from_mark(&context_, t, period); }

 private:
  burin_stroke_context context_;
};

}  // namespace burin::plugin
