/* burin/abi/stroke.h - what evaluate() sees: the stroke as a whole, a batch of chart nodes, outputs.
 *
 * The chart gives each node x near the stroke the coordinates (t, d): t is the arc length along the
 * stroke at the nearest point, d the geodesic distance to it, positive on the left of the direction of
 * travel. At every node stands a right-handed frame (e1, e2, n): e1 along the stroke, n the outward
 * normal, e2 = n x e1 in the direction of growing d. In round caps t and d are normal coordinates of the
 * end's frame: the distance to the stroke is hypot(t, d) before its begin and hypot(t - length, d) after.
 *
 * Chart, frames and displacement belong to the base surface: the surface as it was before the stroke, and as
 * smooth as the stroke feels it. Relief that is narrow against the radius is left out of it, as far as the
 * stroke does not follow it; displacement along the frames of the base adds to such relief. The fine surface
 * has all of it: the vertices as they are. Of a stroke that follows every bump both are the same.
 */
#ifndef BURIN_ABI_STROKE_H
#define BURIN_ABI_STROKE_H

#include "param.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Inputs a brush may read; bits of burin_brush_descriptor.inputs_read. */
#define BURIN_INPUT_T (UINT64_C(1) << 0)
#define BURIN_INPUT_D (UINT64_C(1) << 1)
#define BURIN_INPUT_RADIUS (UINT64_C(1) << 2)
#define BURIN_INPUT_STRETCH (UINT64_C(1) << 3)
#define BURIN_INPUT_FOOTPRINT (UINT64_C(1) << 4)
#define BURIN_INPUT_POSITION (UINT64_C(1) << 5)
#define BURIN_INPUT_NORMAL (UINT64_C(1) << 6)
#define BURIN_INPUT_E1 (UINT64_C(1) << 7)
#define BURIN_INPUT_MEAN_CURVATURE (UINT64_C(1) << 8)
#define BURIN_INPUT_LAPLACIAN (UINT64_C(1) << 9)
#define BURIN_INPUT_DISPLACEMENT (UINT64_C(1) << 10)
#define BURIN_INPUT_MASK (UINT64_C(1) << 11)
#define BURIN_INPUT_COLOUR (UINT64_C(1) << 12)
#define BURIN_INPUT_SHEET (UINT64_C(1) << 13)
#define BURIN_INPUT_VISIT_COUNT (UINT64_C(1) << 14)
#define BURIN_INPUT_NODE_ID (UINT64_C(1) << 15)
#define BURIN_INPUT_SYMMETRY (UINT64_C(1) << 16)
#define BURIN_INPUT_PRESSURE (UINT64_C(1) << 17)
#define BURIN_INPUT_TILT (UINT64_C(1) << 18)
#define BURIN_INPUT_TWIST (UINT64_C(1) << 19)
#define BURIN_INPUT_SPEED (UINT64_C(1) << 20)
#define BURIN_INPUT_TIME (UINT64_C(1) << 21)
#define BURIN_INPUT_FOOT (UINT64_C(1) << 22)
#define BURIN_INPUT_FINE_POSITION (UINT64_C(1) << 23)
#define BURIN_INPUT_FINE_NORMAL (UINT64_C(1) << 24)
#define BURIN_INPUT_FINE_MEAN_CURVATURE (UINT64_C(1) << 25)

/* Outputs a brush may write; bits of burin_brush_descriptor.outputs_written. */
#define BURIN_OUTPUT_DISPLACEMENT (UINT64_C(1) << 0)
#define BURIN_OUTPUT_MASK (UINT64_C(1) << 1)
#define BURIN_OUTPUT_COLOUR (UINT64_C(1) << 2)

/* Bits of burin_stroke_context.flags. */
#define BURIN_STROKE_CLOSED (UINT64_C(1) << 0)   /* t lives modulo length; only with BURIN_STROKE_FINAL */
#define BURIN_STROKE_FINAL (UINT64_C(1) << 1)    /* the pen is up: length will not change any more */
#define BURIN_STROKE_MIRRORED (UINT64_C(1) << 2) /* a symmetry instance that is a mirror image: d, e2 and */
                                                 /* `across` point to the right of the direction of travel */
#define BURIN_STROKE_DAB (UINT64_C(1) << 3)      /* one dab of a stroke of dabs: length is 0, t and d are */
                                                 /* normal coordinates around it, and there are no ends; */
                                                 /* always with BURIN_STROKE_FINAL, never _CLOSED */

/* Constant during a call. */
typedef struct burin_stroke_context {
  uint32_t struct_size;
  uint32_t pass;        /* 0 .. burin_stroke_plan.passes - 1 */
  uint64_t flags;       /* BURIN_STROKE_*; a bit that is not known is to be ignored */
  uint64_t pen_present; /* BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME: what the recording really has */
  uint64_t seed;        /* key of the counter-based generator, with node id and channel */
  double length;        /* arc length of the stroke so far */
  double radius_min;    /* bounds of the radius along the stroke, however it will go on: from begin on */
  double radius_max;    /* the same two numbers in every call of a stroke */
  double object_scale;  /* diagonal of the surface's bounding box */
  double dab_t; /* of a dab (BURIN_STROKE_DAB): arc length along the stroke at which it lies, else 0 */
} burin_stroke_context;

/* Chart nodes, one element each. An array that the brush did not declare in inputs_read is null, and
 * so is an array that the host's version does not know. The host refuses a brush at creation when it
 * reads an input that this host does not offer; what is declared and offered is always filled.
 * Pen inputs that the recording lacks (context.pen_present) are filled with the stated neutral value. */
typedef struct burin_batch {
  uint32_t struct_size;
  uint32_t count; /* elements; usually 256 .. 4096, at least 1 */
  const burin_params* params;
  burin_floats t;              /* arc length along the stroke; < 0 and > length within round caps */
  burin_floats d;              /* signed geodesic distance to the stroke; |d| <= radius */
  burin_floats radius;         /* half width of the stroke at t */
  burin_floats stretch;        /* J = |dP/dt| at constant d; 1 on the stroke */
  burin_floats footprint_t;    /* size of the node's cell along t, object units */
  burin_floats footprint_d;    /* the same across */
  burin_vectors position;      /* base surface; from the second pass on, as the pass before displaced it */
  burin_vectors normal;        /* base surface, unit, outward */
  burin_vectors e1;            /* unit, tangent to the base surface; e2 = normal x e1 */
  burin_floats mean_curvature; /* base surface, 1/length, positive where convex seen from outside */
  burin_vectors laplacian;     /* umbrella: mean of the neighbours minus the node, current fine surface */
  burin_vectors displacement;  /* by the passes before: x along e1, y along e2, z along the normal */
  burin_floats mask;           /* 0 = protected .. 1 = free */
  burin_colours colour;        /* the surface's so far */
  burin_indices sheet;         /* which pass of a self-overlapping stroke, by rising t, from 0 */
  burin_indices visit_count;   /* number of sheets at this place, at least 1 */
  burin_indices node_id;       /* stable name of the vertex: counter of the random generator */
  burin_indices symmetry;      /* symmetry instance, 0 = drawn by hand */
  burin_floats pressure;       /* at t: 0..1; neutral 1 */
  burin_floats tilt_x, tilt_y; /* at t: radians from upright; neutral 0 */
  burin_floats twist;          /* at t: radians, 0..2 pi; neutral 0 */
  burin_floats speed;          /* at t: object units a second; neutral 0 */
  burin_floats time;           /* at t: seconds since the stroke began; neutral 0 */
  burin_vectors foot;          /* at t: mean place of the stroke's points within one radius either side */
  burin_vectors foot_normal; /* the same of their normals, unit: with foot a plane that the stroke lies in */
  burin_vectors fine_position; /* fine surface; from the second pass on, as the pass before displaced it */
  burin_vectors fine_normal;   /* fine surface, unit, outward */
  burin_floats fine_mean_curvature; /* fine surface, 1/length, positive where convex seen from outside */
} burin_batch;

/* Filled with zero (colour: the colour so far; mask: the mask so far) before evaluate is called. An
 * output that the brush did not declare in outputs_written has null data. Every value written must be
 * finite: the host rejects the stroke otherwise. The host multiplies displacement by the strength of
 * the stroke and by the node's mask. From the colour so far it goes to the one written by the same product,
 * within 0..1, and from the mask so far by the strength alone: so strength 0 leaves every surface untouched.
 */
typedef struct burin_outputs {
  uint32_t struct_size;
  uint32_t count;             /* equals the batch's */
  burin_floats_out along;     /* displacement from the base surface along e1, object units; all three
                               * together at most 1000 radii long, or the stroke fails */
  burin_floats_out across;    /* the same along e2 */
  burin_floats_out up;        /* the same along the normal */
  burin_floats_out mask;      /* 0..1 */
  burin_floats_out colour[4]; /* linear RGBA, 0..1 */
} burin_outputs;

#ifdef __cplusplus
}
#endif
#endif
