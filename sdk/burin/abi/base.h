/* burin/abi/base.h - what every other header of the ABI uses.
 *
 * The ABI is C11 and stands on <stddef.h> and <stdint.h> alone. Rules that hold everywhere:
 *  - Lengths are in object units of the mesh, angles in radians, time in seconds, pressure in 0..1.
 *  - Every struct that may grow starts with `uint32_t struct_size`, set by whoever fills the struct.
 *    A reader takes a member only if struct_size covers it (BURIN_HAS); a missing tail means the
 *    defaults that its members document, zero or null where they say nothing. Structs marked FROZEN
 *    never grow.
 *  - Whoever allocates, frees. Buffers belong to the caller; text that a call returns lives until the
 *    object that returned it is destroyed.
 *  - Enumerations are int32_t or bit masks in uint64_t; the value 0 of an enumeration means "unknown".
 *  - A tag in brackets names the thread and the state in which a function may be called:
 *      [main-thread]        the one thread on which the host loads plugins
 *      [stroke-thread]      the one thread that owns a stroke; another stroke may have another
 *      [any thread, concurrent]  at any time within the state named, also several calls at once
 *  - No exception and no longjmp crosses the ABI.
 */
#ifndef BURIN_ABI_BASE_H
#define BURIN_ABI_BASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A plugin is refused when its major differs from the host's; the minor counts additions. */
#define BURIN_ABI_MAJOR 1u
#define BURIN_ABI_MINOR 1u

#if defined(_WIN32)
#define BURIN_CALL __cdecl
#else
#define BURIN_CALL
#endif

/* True when *object is large enough to hold `member`. */
#define BURIN_HAS(object, type, member) \
  ((object)->struct_size >= offsetof(type, member) + sizeof((object)->member))

typedef int32_t burin_status;
enum {
  BURIN_STATUS_UNKNOWN = 0, /* never returned on purpose: a zeroed result is no success */
  BURIN_OK = 1,
  BURIN_ERROR = 2,            /* anything the text explains */
  BURIN_INVALID_ARGUMENT = 3, /* the caller broke the contract */
  BURIN_UNSUPPORTED = 4,      /* valid, but not offered here */
  BURIN_NOT_FOUND = 5,        /* a file, id or handle that does not exist */
  BURIN_OUT_OF_MEMORY = 6
};

/* Where a failing call may leave one line of UTF-8 text. The caller owns `data`; the callee writes at
 * most `capacity` bytes including the terminating zero, cutting longer text. A null burin_text* or a
 * capacity of 0 means the caller wants none. Only looked at when the call failed. */
typedef struct burin_text {
  uint32_t struct_size;
  uint32_t capacity; /* bytes */
  char* data;
} burin_text;

/* FROZEN. Element i is data[i * stride]; stride 0 gives one value for all elements.
 * data is null when the array was not asked for or is not offered. */
typedef struct burin_floats {
  const float* data;
  uint32_t stride; /* floats from one element to the next */
  uint32_t reserved;
} burin_floats;

/* FROZEN. As burin_floats, for whole numbers. */
typedef struct burin_indices {
  const uint32_t* data;
  uint32_t stride; /* elements from one to the next */
  uint32_t reserved;
} burin_indices;

/* FROZEN. As burin_floats, but written to. stride is never 0. */
typedef struct burin_floats_out {
  float* data;
  uint32_t stride; /* floats from one element to the next */
  uint32_t reserved;
} burin_floats_out;

/* FROZEN. Three arrays: components in object space unless the member says otherwise. */
typedef struct burin_vectors {
  burin_floats x, y, z;
} burin_vectors;

/* FROZEN. Linear RGB and coverage, each 0..1. */
typedef struct burin_colours {
  burin_floats r, g, b, a;
} burin_colours;

#ifdef __cplusplus
}
#endif
#endif
