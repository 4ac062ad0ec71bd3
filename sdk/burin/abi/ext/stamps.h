/* burin/abi/ext/stamps.h - host service: images sampled at (u, v).
 *
 * (0, 0) is the upper left corner of the image and (1, 1) the lower right; texel centres lie at
 * ((i + 0.5) / width, (j + 0.5) / height). Images repeat with period 1 in both directions.
 */
#ifndef BURIN_ABI_EXT_STAMPS_H
#define BURIN_ABI_EXT_STAMPS_H

#include "../host.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_STAMPS "burin.stamps/1"

/* FROZEN. */
typedef struct burin_stamp {
  uint64_t handle; /* 0 = none */
} burin_stamp;

/* The caller sets struct_size; open fills the rest. */
typedef struct burin_stamp_info {
  uint32_t struct_size;
  uint32_t width, height; /* texels */
  uint32_t channels;
  float minimum, maximum; /* over all texels of the first channel */
} burin_stamp_info;

typedef struct burin_stamps {
  uint32_t struct_size;
  uint32_t reserved;

  /* Opens an image of floating-point texels. The same file may be opened many times and is held in
   * memory once. info may be null. [stroke-thread] */
  burin_status(BURIN_CALL* open)(const burin_host* host, const char* path, burin_stamp* stamp,
                                 burin_stamp_info* info, burin_text* error);

  /* Gives back what open returned. [stroke-thread, no sample call running] */
  void(BURIN_CALL* close)(const burin_host* host, burin_stamp stamp);

  /* Bilinear samples of one channel at `count` places. `values` holds count elements.
   * [any thread, concurrent, between open and close] */
  burin_status(BURIN_CALL* sample)(const burin_host* host, burin_stamp stamp, uint32_t channel,
                                   uint32_t count, burin_floats u, burin_floats v, burin_floats_out values);
} burin_stamps;

#ifdef __cplusplus
}
#endif
#endif
