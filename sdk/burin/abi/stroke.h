/* burin/abi/stroke.h - what evaluate() sees: the stroke as a whole, a batch of chart nodes, outputs.
 *
 * The chart gives each node near the stroke the coordinates (t, d): t is the arc length along the
 * stroke at the nearest point, d the geodesic distance to it, positive on the left of the direction of
 * travel. Every node has a right-handed frame (e1, e2, n): e1 along the stroke, n the outward normal,
 * e2 = n x e1 in the direction of increasing d. In the mirror image of a stroke (BURIN_STROKE_MIRRORED) the
 * frame is left-handed: d and e2 = e1 x n point to the right. In round caps t and d are geodesic normal
 * coordinates in the frame of the end: the distance to the stroke is hypot(t, d) before its start and hypot(t
 * - length, d) after its end.
 *
 * Chart, frames and displacement refer to the base surface: the surface before the stroke, smoothed as far
 * as the stroke's `follow` setting says. Relief that is narrow compared with the radius is missing from it,
 * and displacement along the frames of the base surface is added to that relief. The fine surface has all
 * relief: it is the vertices themselves. For a stroke that follows every bump both surfaces are the same.
 */
#ifndef BURIN_ABI_STROKE_H
#define BURIN_ABI_STROKE_H

#include "param.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Inputs that a brush may read: bits of burin_brush_descriptor.inputs_read. */
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
#define BURIN_INPUT_END_DISTANCE (UINT64_C(1) << 26) /* since 1.3 */

/* Outputs that a brush may write: bits of burin_brush_descriptor.outputs_written. */
#define BURIN_OUTPUT_DISPLACEMENT (UINT64_C(1) << 0)
#define BURIN_OUTPUT_MASK (UINT64_C(1) << 1)
#define BURIN_OUTPUT_COLOUR (UINT64_C(1) << 2)

/* Bits of burin_stroke_context.flags. */
#define BURIN_STROKE_CLOSED (UINT64_C(1) << 0)   /* t is periodic in length: t and t + length */
                                                 /* are one place, and a node may have either; */
                                                 /* only with BURIN_STROKE_FINAL */
#define BURIN_STROKE_FINAL (UINT64_C(1) << 1)    /* the piece has ended: length stays as it is */
#define BURIN_STROKE_MIRRORED (UINT64_C(1) << 2) /* a symmetry instance that is a mirror image: d, e2 and */
                                                 /* `across` point to the right of the direction of travel */
#define BURIN_STROKE_DAB (UINT64_C(1) << 3)      /* one dab of a stroke of dabs: length is 0, t and d are */
                                                 /* geodesic normal coordinates around it, and it has no */
                                                 /* ends; always with BURIN_STROKE_FINAL, never _CLOSED */

/* The stroke as a whole. Constant during a call. */
typedef struct burin_stroke_context {
  uint32_t struct_size;
  uint32_t pass;        /* 0 .. burin_stroke_plan.passes - 1 */
  uint64_t flags;       /* BURIN_STROKE_*; brushes ignore bits that they do not know */
  uint64_t pen_present; /* BURIN_INPUT_PRESSURE .. BURIN_INPUT_TIME: the inputs that the pen reports */
  uint64_t seed;        /* key of random numbers, so that a stroke drawn again is the same. Number
                           `counter` of `channel` is s(s(seed, channel), counter), where s(a, i) is:
                             x = a + 0x9E3779B97F4A7C15 * (i + 1)
                             x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9
                             x = (x ^ (x >> 27)) * 0x94D049BB133111EB
                             s = x ^ (x >> 31)
                           modulo 2^64; its highest 24 bits times 2^-24 are uniform in 0 .. 1 */
  double length;        /* arc length of the stroke so far, object units */
  double radius_min;    /* lower bound of the stroke's radius, drawn or not yet, object units */
  double radius_max;    /* upper bound; both are the same in every call of a stroke, begin included */
  double object_scale;  /* diagonal of the surface's bounding box, object units */
  double dab_t; /* for a dab (BURIN_STROKE_DAB) its arc length along the stroke, object units; else 0 */
} burin_stroke_context;

/* The chart nodes to evaluate, one element per node. An array is null if the brush did not declare it in
 * inputs_read or if the host's version does not know it. A host refuses to create a brush that reads an input
 * that it does not supply, so a batch never ends before a declared input; it always fills what is declared
 * and supplied. Inputs are finite and radius is above 0; with others a brush may fail but must not crash. Pen
 * inputs that the pen does not report (context.pen_present) are filled with the stated neutral value. */
typedef struct burin_batch {
  uint32_t struct_size;
  uint32_t count; /* elements; usually 256 .. 4096, at least 1, at most 2^31 */
  const burin_params* params;
  burin_floats t;              /* arc length along the stroke; < 0 and > length within round caps */
  burin_floats d;              /* signed geodesic distance to the stroke; |d| <= radius */
  burin_floats radius;         /* half width of the stroke at t */
  burin_floats stretch;        /* J = |dP/dt| at constant d; 1 on the stroke */
  burin_floats footprint_t;    /* size of the node's cell along the stroke, object units */
  burin_floats footprint_d;    /* size of the node's cell across the stroke, object units */
  burin_vectors position;      /* base surface; from the second pass on, displaced by the previous passes */
  burin_vectors normal;        /* base surface, unit, outward */
  burin_vectors e1;            /* unit, tangent to the base surface; e2 = normal x e1, negated if MIRRORED */
  burin_floats mean_curvature; /* base surface, 1/length, positive where convex seen from outside */
  burin_vectors laplacian;     /* umbrella: mean of the neighbours minus the vertex, current fine surface */
  burin_vectors displacement;  /* written by the previous pass, before the strength: x along e1,
                                  y along e2, z along the normal */
  burin_floats mask;           /* current mask of the vertex: 0 = protected .. 1 = free */
  burin_colours colour;        /* current colour of the vertex; 1, 1, 1, 0 where nothing is painted */
  burin_indices sheet;         /* number of the visit to the vertex, in the order of t, from 0 */
  burin_indices visit_count;   /* how often the stroke visits the vertex (number of sheets), at least 1 */
  burin_indices node_id;       /* stable number of the vertex: counter for the random generator */
  burin_indices symmetry;      /* symmetry instance, 0 = the stroke as drawn */
  burin_floats pressure;       /* at t: 0..1; neutral 1 */
  burin_floats tilt_x, tilt_y; /* at t: radians from upright; neutral 0 */
  burin_floats twist;          /* at t: radians, 0..2 pi; neutral 0 */
  burin_floats speed;          /* at t: object units per second; neutral 0 */
  burin_floats time;           /* at t: seconds since the stroke began; neutral 0 */
  burin_vectors foot;          /* at t: mean position of the curve within one radius before and after */
  burin_vectors
      foot_normal; /* at t: mean normal over the same part, unit; foot and foot_normal are a plane */
  burin_vectors fine_position; /* fine surface; from the second pass on, displaced by the previous passes */
  burin_vectors fine_normal;   /* fine surface, unit, outward */
  burin_floats fine_mean_curvature; /* fine surface, 1/length, positive where convex seen from outside */
  burin_floats end_distance; /* since 1.3: how far the node is from the stroke's nearer end along the stroke,
                                at most burin_stroke_plan.end_influence, object units, >= 0; finite, and as
                                great as possible, for strokes without ends. For tapered ends: it is that of
                                t, but has only small steps, of 0.35 |d| at most, on the inside of sharp
                                bends, and no corner in the middle of short strokes */
} burin_batch;

/* Where a brush writes its results. The host fills displacement with zero and colour and mask with those
 * before the stroke, anew in every pass, before it calls evaluate: the result is what the last pass writes.
 * A colour or mask beyond 0..1 is allowed, the host brings it within. An output that the brush did not
 * declare in outputs_written has null data. Every value written must be finite, else the stroke fails. The
 * host multiplies displacement by the strength of the stroke and by the node's mask. It interpolates from the
 * current colour to the written one by the same product, clamped to 0..1, and from the current mask to the
 * written one by the strength alone. So strength 0 leaves every surface unchanged.
 */
typedef struct burin_outputs {
  uint32_t struct_size;
  uint32_t count;             /* equals the count of the batch */
  burin_floats_out along;     /* displacement from the base surface along e1, object units; the vector
                               * of all three is at most 1000 radii long, else the stroke fails */
  burin_floats_out across;    /* displacement along e2, object units */
  burin_floats_out up;        /* displacement along the normal, object units */
  burin_floats_out mask;      /* 0..1 */
  burin_floats_out colour[4]; /* linear RGBA, 0..1 */
} burin_outputs;

#ifdef __cplusplus
}
#endif
#endif
