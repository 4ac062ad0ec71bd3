/* burin/abi/ext/stamps.h - host service: images sampled at (u, v).
 *
 * (0, 0) is the upper left corner of the image and (1, 1) the lower right; texel centres lie at
 * ((i + 0.5) / width, (j + 0.5) / height). The wrap of each direction defines the values outside the image.
 */
#ifndef BURIN_ABI_EXT_STAMPS_H
#define BURIN_ABI_EXT_STAMPS_H

#include "../host.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_STAMPS "burin.stamps/1"

/* FROZEN. A handle of an open image. */
typedef struct burin_stamp {
  uint64_t handle; /* 0 = none */
} burin_stamp;

/* The values of an image outside its borders. */
typedef int32_t burin_stamp_wrap;
enum {
  BURIN_WRAP_UNKNOWN = 0,  /* the mode stored in the file, else periodic */
  BURIN_WRAP_PERIODIC = 1, /* the image repeats with period 1 */
  BURIN_WRAP_MIRROR = 2,   /* the image repeats, every other copy mirrored */
  BURIN_WRAP_CLAMP = 3,    /* the nearest texel at the border */
  BURIN_WRAP_BLACK = 4     /* 0 */
};

/* Options for opening an image. */
typedef struct burin_stamp_options {
  uint32_t struct_size;
  burin_stamp_wrap wrap_u, wrap_v;
  uint32_t clean; /* 0: refuse texels that are not finite; 1: fill them from their neighbours and log it */
  /* The layer and channels to use of a file with several; null or empty: chosen by their names. */
  const char* layer;
  const char* channel; /* one name, or three or four separated by commas */
  float zero;          /* the file's value that becomes 0; does not apply to alpha */
  uint32_t reserved;
} burin_stamp_options;

/* Facts about an open image. The caller sets struct_size; open fills the rest. */
typedef struct burin_stamp_info {
  uint32_t struct_size;
  uint32_t width, height; /* texels */
  uint32_t channels;
  float minimum, maximum;          /* over all texels of the first channel */
  burin_stamp_wrap wrap_u, wrap_v; /* the modes in use; never BURIN_WRAP_UNKNOWN */
} burin_stamp_info;

/* FROZEN. The area whose mean is a filtered sample: the ellipse inscribed in the parallelogram that is
 * centred at (u, v) and has the sides (along_u, along_v) and (across_u, across_v), in units of u and v. */
typedef struct burin_stamp_area {
  burin_floats along_u, along_v;
  burin_floats across_u, across_v;
} burin_stamp_area;

/* The service; burin_host.get_extension returns it. */
typedef struct burin_stamps {
  uint32_t struct_size;
  uint32_t reserved;

  /* Opens an image file with default options. The same file may be opened many times and is held in memory
   * once. info may be null. [stroke-thread] */
  burin_status(BURIN_CALL* open)(const burin_host* host, const char* path, burin_stamp* stamp,
                                 burin_stamp_info* info, burin_text* error);

  /* Closes a stamp that open, open_with or burin_lettering.set opened.
   * [stroke-thread, no sample call running] */
  void(BURIN_CALL* close)(const burin_host* host, burin_stamp stamp);

  /* Writes bilinear samples of one channel at `count` positions (u, v) into `values`.
   * [any thread, concurrent, between open and close] */
  burin_status(BURIN_CALL* sample)(const burin_host* host, burin_stamp stamp, uint32_t channel,
                                   uint32_t count, burin_floats u, burin_floats v, burin_floats_out values);

  /* Opens an image file with these options. One file may be open with different options. info may be null.
   * [stroke-thread] */
  burin_status(BURIN_CALL* open_with)(const burin_host* host, const char* path,
                                      const burin_stamp_options* options, burin_stamp* stamp,
                                      burin_stamp_info* info, burin_text* error);

  /* Writes filtered samples: each is the mean of one channel over an area around (u, v), or a bilinear
   * sample where the area is smaller than a texel. With the node's cell as area, results look the same on
   * coarse and fine meshes. [any thread, concurrent, between open and close] */
  burin_status(BURIN_CALL* sample_area)(const burin_host* host, burin_stamp stamp, uint32_t channel,
                                        uint32_t count, burin_floats u, burin_floats v,
                                        const burin_stamp_area* area, burin_floats_out values);
} burin_stamps;

#ifdef __cplusplus
}
#endif
#endif
