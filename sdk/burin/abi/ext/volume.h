/* burin/abi/ext/volume.h - brush ability: solids in stroke space (t, d, h), h the height over the base
 * surface along its normal, positive outside. Made of a finished stroke, where the user asks for a solid:
 * evaluate() is not called then, and a brush without outputs draws nothing else. */
#ifndef BURIN_ABI_EXT_VOLUME_H
#define BURIN_ABI_EXT_VOLUME_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_VOLUME "burin.volume/1"

/* What becomes of a solid unless the user says otherwise. */
enum {
  BURIN_SOLID_SEPARATE = 0,    /* a part of its own, beside the surface */
  BURIN_SOLID_UNION = 1,       /* part of the surface */
  BURIN_SOLID_DIFFERENCE = 2,  /* the surface loses it */
  BURIN_SOLID_INTERSECTION = 3 /* the surface keeps only what is in it */
};

/* Where a solid is and how fine it is. The host sets struct_size and zeros. */
typedef struct burin_solid_plan {
  uint32_t struct_size;
  uint32_t operation;  /* BURIN_SOLID_... */
  double h_min, h_max; /* object units: the solid is empty outside of them */
  double detail; /* object units, above 0: the narrowest wall or gap that must not be lost; the host makes
                    its voxels from it */
} burin_solid_plan;
/* The ability of a brush; get_extension(BURIN_EXT_VOLUME) returns it. */
typedef struct burin_volume {
  uint32_t struct_size;
  uint32_t reserved;

  /* Describes the solid of a finished stroke (BURIN_STROKE_FINAL). Numbers in params have stride 0 and are
   * the values before input dynamics. [stroke-thread, between begin and end] */
  burin_status(BURIN_CALL* plan)(const burin_brush* brush, void* stroke, const burin_stroke_context* context,
                                 const burin_params* params, burin_solid_plan* plan, burin_text* error);

  /* Writes the signed distance to the solid (object units, negative inside) at every point (t, d, h) of
   * a batch of batch->count elements, in the flat metric dt^2 + dd^2 + dh^2: the host makes distances in
   * space of it. Away from the solid a lower bound of the distance is enough. Of the batch's arrays those
   * that the descriptor's inputs_read declares are filled: with what holds at the foot of the point on the
   * base surface, for each sheet of the stroke that has one there by itself. A brush that offers a solid may
   * read T, D, RADIUS, STRETCH, POSITION, NORMAL, E1, SHEET, VISIT_COUNT, NODE_ID, SYMMETRY and the pen's
   * inputs; the host refuses solids of brushes that read others. The solid is the union over all feet and
   * sheets, and is cut off where the stroke is farther than its radius in the surface; the points of a batch
   * may be farther, |d| above the radius too.
   * [any thread, concurrent, between begin and end] */
  burin_status(BURIN_CALL* distance)(const burin_brush* brush, void* stroke,
                                     const burin_stroke_context* context, const burin_batch* batch,
                                     burin_floats h, burin_floats_out distance, burin_text* error);
} burin_volume;

#ifdef __cplusplus
}
#endif
#endif
