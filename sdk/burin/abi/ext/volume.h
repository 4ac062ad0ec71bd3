/* burin/abi/ext/volume.h - brush interface: solids in stroke space (t, d, h), where h is the height above
 * the base surface along its normal, positive outside. */
#ifndef BURIN_ABI_EXT_VOLUME_H
#define BURIN_ABI_EXT_VOLUME_H

#include "../brush.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_VOLUME "burin.volume/1"

/* The interface; burin_brush.get_extension returns it. */
typedef struct burin_volume {
  uint32_t struct_size;
  uint32_t reserved;

  /* Writes bounds of h (object units) outside which the solid is empty.
   * [stroke-thread, between begin and end] */
  burin_status(BURIN_CALL* bounds)(const burin_brush* brush, void* stroke,
                                   const burin_stroke_context* context, const burin_params* params,
                                   double* h_min, double* h_max, burin_text* error);

  /* Writes the signed distance to the solid (object units, negative inside) at the batch->count points
   * (t, d, h). The host fills the arrays of the batch that the brush declared in inputs_read. Away from the
   * solid a lower bound of the distance is enough.
   * [any thread, concurrent, between begin and end] */
  burin_status(BURIN_CALL* distance)(const burin_brush* brush, void* stroke,
                                     const burin_stroke_context* context, const burin_batch* batch,
                                     burin_floats h, burin_floats_out distance, burin_text* error);
} burin_volume;

#ifdef __cplusplus
}
#endif
#endif
