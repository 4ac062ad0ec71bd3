/* burin/abi/param.h - typed parameters: how a brush declares them and receives their values. */
#ifndef BURIN_ABI_PARAM_H
#define BURIN_ABI_PARAM_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The type of a parameter, and how its value is passed. */
typedef int32_t burin_param_type;
enum {
  BURIN_PARAM_UNKNOWN = 0,
  BURIN_PARAM_FLOAT = 1,
  BURIN_PARAM_INT = 2,    /* a float holding a whole number, |value| <= 2^24 */
  BURIN_PARAM_BOOL = 3,   /* a float, 0 or 1 */
  BURIN_PARAM_CHOICE = 4, /* a float holding the index into `choices` */
  BURIN_PARAM_COLOUR = 5, /* four floats, linear RGBA, 0..1 */
  BURIN_PARAM_FILE = 6,   /* a path, UTF-8 */
  BURIN_PARAM_CURVE = 7,  /* knots (x, y), x increasing, linear between knots, constant beyond the ends */
  BURIN_PARAM_TEXT = 8    /* a line of UTF-8 text, may be empty */
};

/* The unit of a number, so that a host can show and scale it. */
typedef int32_t burin_param_unit;
enum {
  BURIN_UNIT_UNKNOWN = 0,
  BURIN_UNIT_NONE = 1,   /* a plain number or ratio; also of types that are no numbers */
  BURIN_UNIT_RADIUS = 2, /* multiples of the stroke's radius */
  BURIN_UNIT_LENGTH = 3, /* object units */
  BURIN_UNIT_ANGLE = 4,  /* radians */
  BURIN_UNIT_TIME = 5    /* seconds */
};

/* Declares a parameter. All text belongs to the plugin, is UTF-8 and lives as long as the descriptor that
 * points to this struct. The host never passes NaN, infinities or values outside the hard range, neither
 * to begin nor in the arrays of dynamic parameters; a brush need not check for them: it may fail or draw
 * anything, but should not crash. begin() checks what a range cannot say: files, texts, several values
 * together. The soft range is what a slider spans, so it is a single number only where the hard range is one.
 * Types other than FLOAT and INT have a range of their own and ignore both. Ids are unique within a brush,
 * those of choices within a parameter. */
typedef struct burin_param_info {
  uint32_t struct_size;
  burin_param_type type;
  const char* id;   /* stable across versions, [a-z0-9_]+: files and scripts use it */
  const char* name; /* for people */
  const char* help; /* one sentence; may be null */
  burin_param_unit unit;
  float hard_min, hard_max;    /* FLOAT, INT: may be infinite; values themselves are finite */
  float soft_min, soft_max;    /* FLOAT, INT: finite, within the hard range */
  float default_number;        /* FLOAT, INT, BOOL, CHOICE; FLOAT, INT: within the hard range */
  float default_colour[4];     /* COLOUR */
  const char* default_file;    /* FILE: null when the user must choose one; "" when none is needed */
  const char* const* choices;  /* CHOICE: stable ids, any UTF-8 but not empty; ended by a null pointer */
  const float* default_knots;  /* CURVE: x0 y0 x1 y1 ... */
  uint32_t default_knot_count; /* CURVE: pairs, at least 1 */
  uint32_t dynamic;            /* 1: may vary along the stroke (input dynamics); 0: constant,
                                  as FILE, TEXT and CURVE always are */
  const char* default_text;    /* TEXT: null means "" */
} burin_param_info;

/* FROZEN. The value of one parameter, in the member that belongs to its declared type. */
typedef struct burin_param_value {
  burin_floats number;    /* FLOAT, INT, BOOL, CHOICE: one number per element, or stride 0 */
  burin_floats colour[4]; /* COLOUR */
  const char* text;       /* TEXT: the text; FILE: a path, absolute or relative to the working directory, or
                             "" for none if that is the default; UTF-8, never null */
  const float* knots;     /* CURVE: x0 y0 x1 y1 ... */
  uint32_t knot_count;    /* CURVE: pairs */
  uint32_t reserved;
} burin_param_value;

/* The values of all parameters, in the order of the descriptor. Immutable; valid during the call. */
typedef struct burin_params {
  uint32_t struct_size;
  uint32_t count; /* equals the descriptor's param_count */
  const burin_param_value* values;
} burin_params;

#ifdef __cplusplus
}
#endif
#endif
