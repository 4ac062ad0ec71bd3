/* burin/abi/ext/stamps.h - host service: images sampled at (u, v).
 *
 * (0, 0) is the upper left corner of the image and (1, 1) the lower right; texel centres lie at
 * ((i + 0.5) / width, (j + 0.5) / height). Beyond them the wrap of either direction says what is there.
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

/* What an image is beyond its borders. */
typedef int32_t burin_stamp_wrap;
enum {
  BURIN_WRAP_UNKNOWN = 0,  /* as the file says; periodic where it says nothing */
  BURIN_WRAP_PERIODIC = 1, /* repeats with period 1 */
  BURIN_WRAP_MIRROR = 2,   /* repeats, every other time mirrored */
  BURIN_WRAP_CLAMP = 3,    /* the texel at the border goes on */
  BURIN_WRAP_BLACK = 4     /* 0 */
};

/* How to open an image. */
typedef struct burin_stamp_options {
  uint32_t struct_size;
  burin_stamp_wrap wrap_u, wrap_v;
  uint32_t clean; /* 0: refuse texels that are not finite; 1: fill them from their neighbours and log it */
  /* Of files with several layers or channels, which: null or empty as their names tell. */
  const char* layer;
  const char* channel; /* one, or three or four between commas */
  float zero; /* the file's value that is to be 0: half for whole numbers with a sign; not of alpha */
  uint32_t reserved;
} burin_stamp_options;

/* The caller sets struct_size; open fills the rest. */
typedef struct burin_stamp_info {
  uint32_t struct_size;
  uint32_t width, height; /* texels */
  uint32_t channels;
  float minimum, maximum;          /* over all texels of the first channel */
  burin_stamp_wrap wrap_u, wrap_v; /* what holds; never BURIN_WRAP_UNKNOWN */
} burin_stamp_info;

/* FROZEN. The part of the image that a sample is the mean of: the ellipse inscribed in the parallelogram
 * whose sides are (along_u, along_v) and (across_u, across_v), units of u and v, around the place. */
typedef struct burin_stamp_area {
  burin_floats along_u, along_v;
  burin_floats across_u, across_v;
} burin_stamp_area;

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

  /* As open, which stands for options of zero. One file may be open with different options.
   * [stroke-thread] */
  burin_status(BURIN_CALL* open_with)(const burin_host* host, const char* path,
                                      const burin_stamp_options* options, burin_stamp* stamp,
                                      burin_stamp_info* info, burin_text* error);

  /* Filtered samples: each the mean of the image over an area, bilinear where the area is smaller than a
   * texel. For what is to look the same however coarse the mesh.
   * [any thread, concurrent, between open and close] */
  burin_status(BURIN_CALL* sample_area)(const burin_host* host, burin_stamp stamp, uint32_t channel,
                                        uint32_t count, burin_floats u, burin_floats v,
                                        const burin_stamp_area* area, burin_floats_out values);
} burin_stamps;

#ifdef __cplusplus
}
#endif
#endif
