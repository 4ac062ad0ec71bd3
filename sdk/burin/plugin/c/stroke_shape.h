/* burin/plugin/c/stroke_shape.h - distances and falloffs of strokes in C, those of Stroke and falloff.h.
 *
 * `stroke` is the context of the call, lengths are object units. The functions may be called on any thread.
 * They have the same bits everywhere if they are compiled with -ffp-contract=off, as burin_add_brush() does.
 */
#ifndef BURIN_PLUGIN_C_STROKE_SHAPE_H
#define BURIN_PLUGIN_C_STROKE_SHAPE_H

#include <burin/abi/stroke.h>
#include <math.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Whether the stroke has ends: closed strokes and dabs have none. */
static inline int burin_has_ends(const burin_stroke_context* stroke) {
  return !(stroke->flags & (BURIN_STROKE_CLOSED | BURIN_STROKE_DAB));
}

/* How far t is beyond an end: negative before the start, positive after the end, else 0. */
static inline float burin_beyond_ends(const burin_stroke_context* stroke, float t) {
  const float after = t - (float)stroke->length;
  if (stroke->flags & BURIN_STROKE_CLOSED) return 0;
  return after > 0 ? after : t > 0 ? 0 : t;
}

/* The distance of the point (t, d) to the stroke: |d| beside it, the distance to the end in the caps. */
static inline float burin_distance(const burin_stroke_context* stroke, float t, float d) {
  const double along = burin_beyond_ends(stroke, t), across = d;
  return along == 0 ? fabsf(d) : (float)sqrt(along * along + across * across);
}

/* The period nearest to `period` of which a whole number fits along the stroke if it is closed. Both are
 * object units, > 0. A brush that repeats along the stroke has no seam then. */
static inline double burin_whole_period(const burin_stroke_context* stroke, double period) {
  const double count = round(stroke->length / period);
  if (!(stroke->flags & BURIN_STROKE_CLOSED) || !(stroke->length > 0)) return period;
  return stroke->length / (count < 1 ? 1 : count);
}

/* The offset along t from the nearest of marks that are `period` apart (object units, > 0). The first mark of
 * an open stroke is at its start, the last one at or before its end, so the end influence is half a period.
 */
static inline float burin_from_mark(const burin_stroke_context* stroke, float t, double period) {
  const double last = floor(stroke->length / period);
  double mark = round(t / period);
  if (!(stroke->flags & BURIN_STROKE_CLOSED)) mark = mark < 0 ? 0 : mark > last ? last : mark;
  return (float)(t - mark * period);
}

/* A smooth step: 0 for x <= 0, 1 for x >= 1, and between them a cubic with zero slope at both ends. */
static inline float burin_smooth_step(float x) {
  const float s = x < 0 ? 0 : x > 1 ? 1 : x;
  return s * s * (3 - 2 * s);
}

/* A factor that fades out towards the rim: 0 at the rim and outside, 1 at least `rim` (a share of the radius,
 * > 0) inside it. */
static inline float burin_rim_factor(const burin_stroke_context* stroke, float t, float d, float radius,
                                     float rim) {
  return burin_smooth_step((1 - burin_distance(stroke, t, d) / radius) / rim);
}

/* How far back from its end a stroke with this taper (radii) depends on its length, object units: what
 * burin_stroke_plan.end_influence must be at least for burin_taper_factor(). */
static inline double burin_taper_influence(const burin_stroke_context* stroke, float taper) {
  return taper > 0 ? (taper < 2 ? 2 : taper) * stroke->radius_max : 0;
}

/* A factor that fades out towards the ends of an open stroke: 0 at an end and beyond, 1 at least `taper`
 * radii inside. A stroke shorter than a radius fades out less, and a tap, whose length is 0, not at all.
 * `end_distance` is the input of this name. */
static inline float burin_taper_factor(const burin_stroke_context* stroke, float end_distance, float radius,
                                       float taper) {
  const float share = (float)(stroke->length / radius);
  if (!burin_has_ends(stroke) || taper == 0) return 1;
  return 1 - (share < 1 ? share : 1) * (1 - burin_smooth_step(end_distance / (taper * radius)));
}

#ifdef __cplusplus
}
#endif
#endif
