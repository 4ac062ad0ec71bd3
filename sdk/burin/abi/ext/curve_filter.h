/* burin/abi/ext/curve_filter.h - brush interface: moves the curve of the stroke before it gets a chart. */
#ifndef BURIN_ABI_EXT_CURVE_FILTER_H
#define BURIN_ABI_EXT_CURVE_FILTER_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_CURVE_FILTER "burin.curve-filter/1"

/* Points of the stroke's surface curve, in the order of t. */
typedef struct burin_curve_points {
  uint32_t struct_size;
  uint32_t count;
  burin_floats t;         /* arc length at the point */
  burin_vectors position; /* on the base surface */
  burin_vectors normal;   /* unit, outward */
  burin_vectors e1;       /* unit, tangent to surface and curve */
} burin_curve_points;

/* The interface; burin_brush.get_extension returns it. */
typedef struct burin_curve_filter {
  uint32_t struct_size;
  uint32_t reserved;

  /* Returns how far ahead (object units, >= 0) the moved curve depends on the drawn one. It may be infinite;
   * the host then filters finished strokes only. The value does not change during a stroke.
   * [stroke-thread, between begin and end] */
  double(BURIN_CALL* lookahead)(const burin_brush* brush, void* stroke);

  /* Writes the offset of every point along e1 (along) and e2 (across), object units. The host fills both
   * with zero before the call, and projects the moved points onto the surface.
   * [stroke-thread, between begin and end] */
  burin_status(BURIN_CALL* filter)(const burin_brush* brush, void* stroke,
                                   const burin_stroke_context* context, const burin_params* params,
                                   const burin_curve_points* points, burin_floats_out along,
                                   burin_floats_out across, burin_text* error);
} burin_curve_filter;

#ifdef __cplusplus
}
#endif
#endif
