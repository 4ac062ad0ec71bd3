/* burin/abi/ext/curve_filter.h - brush ability: moves the curve of the stroke before it gets a chart.
 *
 * The drawn curve stays what tells whether a stroke closes and where its pieces end. The chart is that of the
 * moved curve, and evaluate() sees the moved curve only: its length, its t. Each piece of a stroke, and each
 * symmetric image, has a curve of its own.
 *
 * No host served the first draft of this header, which had `lookahead` only. What a moved point depends on
 * behind it is told now too, for otherwise every sample would cost as much as the whole stroke is long.
 */
#ifndef BURIN_ABI_EXT_CURVE_FILTER_H
#define BURIN_ABI_EXT_CURVE_FILTER_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_CURVE_FILTER "burin.curve-filter/1"

/* How much of the drawn curve a moved point depends on: from t - behind to t + ahead. Object units, >= 0,
 * may be infinite. The host sets struct_size and zeros. */
typedef struct burin_curve_reach {
  uint32_t struct_size;
  uint32_t reserved;
  double behind;
  double ahead; /* infinite: the curve is moved when the stroke ends, and shown as drawn until then */
} burin_curve_reach;

/* Successive points of the drawn curve, in the order of t: half an edge of the surface apart, or less. */
typedef struct burin_curve_points {
  uint32_t struct_size;
  uint32_t count;         /* at least 1 */
  burin_floats t;         /* arc length at the point, object units */
  burin_vectors position; /* on the base surface */
  burin_vectors normal;   /* unit, outward */
  burin_vectors e1;       /* unit, tangent to surface and curve; e2 = normal x e1 */
} burin_curve_points;

/* The interface; burin_brush.get_extension returns it. */
typedef struct burin_curve_filter {
  uint32_t struct_size;
  uint32_t reserved;

  /* Tells the reach, which does not change during a stroke. [stroke-thread, between begin and end] */
  void(BURIN_CALL* reach)(const burin_brush* brush, void* stroke, burin_curve_reach* reach);

  /* Writes the offset of every point along e1 (along) and e2 (across), object units, finite, at most 100
   * radii; the host fills both with zero before the call. It moves the point along the geodesic in that
   * direction, until where the surface ends or folds back if that is nearer.
   *
   * The points are a part of the curve. The host takes the offsets of those whose reach lies in it, or goes
   * beyond an end of the curve, and calls again with another part as the curve grows. The offset of such a
   * point must be the same, to the bit, whatever the part and however long the stroke is by then. So it
   * may depend on context->length within `ahead` of it only.
   *
   * context->length is that of the drawn curve. BURIN_STROKE_CLOSED tells that t is periodic in it; then the
   * points are those of the whole curve, whose last segment leads from the last point to the first.
   * BURIN_STROKE_FINAL comes with the last call for a curve. With BURIN_STROKE_MIRRORED `across` points to
   * the right of the direction of travel. Numbers in params have stride 0 and are the values before input
   * dynamics. [stroke-thread, between begin and end] */
  burin_status(BURIN_CALL* filter)(const burin_brush* brush, void* stroke,
                                   const burin_stroke_context* context, const burin_params* params,
                                   const burin_curve_points* points, burin_floats_out along,
                                   burin_floats_out across, burin_text* error);
} burin_curve_filter;

#ifdef __cplusplus
}
#endif
#endif
