/* burin/abi/base.h - types and rules that every other header of the ABI uses.
 *
 * The ABI is C11 and needs <stddef.h> and <stdint.h> only. Rules that hold everywhere:
 *  - Lengths are in object units of the mesh, angles in radians, time in seconds, pressure in 0..1.
 *  - Every struct that may grow starts with `uint32_t struct_size`, set by whoever fills the struct.
 *    A reader reads a member only if struct_size covers it (BURIN_HAS). A missing member has the default
 *    that its comment states, else zero or null. Structs marked FROZEN never grow. The least struct_size is
 *    that of version 1.0: hosts give no smaller one, and refuse smaller ones of plugins.
 *  - Whoever allocates memory frees it. Buffers belong to the caller; text that a call returns lives until
 *    the object that returned it is destroyed.
 *  - Enumerations are int32_t or bit masks in uint64_t; the value 0 of an enumeration means "unknown".
 *  - A tag in brackets states the thread and the state in which a function may be called:
 *      [main-thread]        the one thread on which the host loads plugins
 *      [stroke-thread]      the one thread that owns a stroke; different strokes may have different ones
 *      [any thread, concurrent]  at any time within the stated state, also several calls at once
 *  - No exception and no longjmp crosses the ABI.
 *  - A call leaves the process as it was: locale, standard streams, signal handlers, working directory,
 *    environment, rounding mode and the flushing of denormals. init, create and begin may read files;
 *    evaluate and whatever else is marked concurrent must not open files or write to streams.
 *    Neither should it allocate memory or lock, for it runs on all of a machine's processors at once.
 *  - Every call returns. A host may end a process whose call takes longer than 20 seconds.
 */
#ifndef BURIN_ABI_BASE_H
#define BURIN_ABI_BASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A host refuses a plugin whose major version differs from its own. The minor version counts additions. */
#define BURIN_ABI_MAJOR 1u
#define BURIN_ABI_MINOR 3u
/* The calling convention of all functions that cross the ABI. */
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
  BURIN_STATUS_UNKNOWN = 0, /* never returned on purpose, so that a zeroed result is not a success */
  BURIN_OK = 1,
  BURIN_ERROR = 2,            /* an error that the text explains */
  BURIN_INVALID_ARGUMENT = 3, /* the caller broke the contract */
  BURIN_UNSUPPORTED = 4,      /* a valid request that this implementation does not support */
  BURIN_NOT_FOUND = 5,        /* a file, id or handle that does not exist */
  BURIN_OUT_OF_MEMORY = 6
};

/* A buffer for one line of UTF-8 text that explains why a call failed. The caller owns `data`; the callee
 * writes at most `capacity` bytes including the terminating zero and cuts longer text, between characters. A
 * null burin_text* or a capacity of 0 means that the caller wants no text. The content is defined only when
 * the call failed. */
typedef struct burin_text {
  uint32_t struct_size;
  uint32_t capacity; /* bytes */
  char* data;
} burin_text;

/* FROZEN. An array to read: element i is data[i * stride]; stride 0 gives one value for all elements.
 * data is null when the brush did not declare the array or the host does not supply it. */
typedef struct burin_floats {
  const float* data;
  uint32_t stride; /* floats from one element to the next */
  uint32_t reserved;
} burin_floats;

/* FROZEN. An array of unsigned integers to read, laid out as in burin_floats. */
typedef struct burin_indices {
  const uint32_t* data;
  uint32_t stride; /* elements from one to the next */
  uint32_t reserved;
} burin_indices;

/* FROZEN. An array to write, laid out as in burin_floats; stride is never 0. */
typedef struct burin_floats_out {
  float* data;
  uint32_t stride; /* floats from one element to the next */
  uint32_t reserved;
} burin_floats_out;

/* FROZEN. Vectors as three arrays of components, in object space unless the member says otherwise. */
typedef struct burin_vectors {
  burin_floats x, y, z;
} burin_vectors;

/* FROZEN. Colours as four arrays: linear RGB and coverage (alpha), each 0..1. */
typedef struct burin_colours {
  burin_floats r, g, b, a;
} burin_colours;

#ifdef __cplusplus
}
#endif
#endif
