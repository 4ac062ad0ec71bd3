/* burin/abi/brush.h - a brush: its descriptor, its lifetime and its evaluation.
 *
 * A brush is a pointwise function over the stroke chart. It never sees the mesh; it declares what it needs
 * of a node's surroundings as inputs. Calls during the lifetime of a brush:
 *
 *   create -> { begin -> evaluate* -> end }* -> destroy
 *
 * Several strokes of one brush may be open at once, each with a `stroke` of its own; evaluate may run
 * on many threads at once for one stroke. evaluate is a pure function of context, parameters, batch and of
 * what begin made of the stroke, which may hold the brush's state (ext/state.h), contents of files and
 * services of the host that do not change during a stroke: the host may split nodes into batches as it likes,
 * evaluate them in any order and evaluate them again.
 *
 * Results follow the surface: a surface and stroke that are moved, mirrored or scaled, with parameters in
 * units of length scaled too, get the same result moved, mirrored or scaled, within rounding. A brush for
 * which that does not hold, since it looks at places in space or writes letters, says so by features.
 */
#ifndef BURIN_ABI_BRUSH_H
#define BURIN_ABI_BRUSH_H

#include "host.h"
#include "stroke.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How the results of several visits are combined. A stroke visits a vertex several times when it crosses
 * itself, comes back, is a row of dabs, consists of pieces or has symmetric images. Each visit has a node
 * of its own at the vertex, called a sheet. STRONGEST and ADD take every sheet in full. In the other modes a
 * sheet fades in over the outer three quarters of its half width, so that the result is continuous at its
 * rim. */
typedef int32_t burin_overlap;
enum {
  BURIN_OVERLAP_UNKNOWN = 0,   /* the brush does not say; the host uses STRONGEST */
  BURIN_OVERLAP_STRONGEST = 1, /* highest rise plus deepest cut; greatest coverage of colours and masks */
  BURIN_OVERLAP_LATEST = 2,    /* the sheet drawn last lies on top: for patterns, which do not mix */
  BURIN_OVERLAP_MAX = 3,       /* the sheet that moves the vertex farthest outward; the most of a colour */
  BURIN_OVERLAP_MIN = 4,       /* the sheet that moves it farthest inward; the least of a colour */
  BURIN_OVERLAP_ADD = 5,       /* the sum of all sheets */
  BURIN_OVERLAP_AVERAGE = 6    /* the mean of all sheets */
};

/* Features that mean something to a host; others are tags for people, "procedural", "stamp". Those that begin
 * with "burin." are the ABI's. Each of these three excepts a brush from following the surface. */
#define BURIN_FEATURE_FIXED_PLACE "burin.fixed-place" /* rotations and moves change the result */
#define BURIN_FEATURE_ONE_HANDED "burin.one-handed"   /* mirroring changes the result */
#define BURIN_FEATURE_FIXED_SCALE "burin.fixed-scale" /* scaling changes the result */

/* Describes a brush. Owned by the plugin; lives from init to deinit. Ids and texts are UTF-8. */
typedef struct burin_brush_descriptor {
  uint32_t struct_size;
  uint32_t param_count;
  const char* id;   /* reverse DNS, "org.burin.groove": never changes, unique among all brushes */
  const char* name; /* for people */
  const char* vendor;
  const char* version;                   /* of the brush, "1.2.0" */
  const char* help;                      /* one or two sentences; may be null */
  const char* const* features;           /* never null; ended by a null pointer */
  const burin_param_info* const* params; /* param_count pointers; their order is that of burin_params;
                                            null only if param_count is 0 */
  uint64_t inputs_read;                  /* BURIN_INPUT_* */
  uint64_t outputs_written;              /* BURIN_OUTPUT_* */
  burin_overlap overlap;                 /* since 1.1: default strongest; users may choose another */
  uint32_t reserved;                     /* since 1.1: 0 */
  float rim_slope;    /* since 1.2: how steeply results rise from the rim, where the distance to the stroke is
                         the radius and the surface stays as it is: a displacement is at most this number
                         times the distance to the rim. 0, the default: not stated; infinity: steps */
  uint32_t reserved2; /* since 1.2: 0 */
} burin_brush_descriptor;

/* What a stroke needs of the host. It may depend on the parameters, so begin() returns it. The host sets
 * struct_size and the defaults; the brush changes the members that differ. */
typedef struct burin_stroke_plan {
  uint32_t struct_size;
  uint32_t passes;      /* >= 1, default 1: evaluate runs over the whole stroke once per pass, and the
                           inputs position, laplacian, displacement and fine_position are those after the
                           previous pass; mask, colour and all others do not change. A pass is no visit:
                           what number the visit of a node has tells the input `sheet` */
  double end_influence; /* how far back from the end (object units, >= 0, default 0) the result depends
                           on context.length or BURIN_STROKE_FINAL; infinity is allowed. When either
                           changes, the host evaluates again all nodes with
                           t > (previous length) - end_influence, round cap included. Where a stroke
                           closes it evaluates all nodes again */
} burin_stroke_plan;

/* A brush and its functions. Made by burin_brush_factory.create. */
typedef struct burin_brush {
  uint32_t struct_size;
  uint32_t reserved;
  void* self; /* for the plugin's use; the host does not touch it */

  /* Frees the brush. [main-thread, no stroke open] */
  void(BURIN_CALL* destroy)(const struct burin_brush* brush);

  /* Returns the brush's optional interface with this id ("burin.NAME/1", see ext/), or null. It lives as
   * long as the brush. [any thread, concurrent] */
  const void*(BURIN_CALL* get_extension)(const struct burin_brush* brush, const char* id);

  /* Begins a stroke: checks parameters, opens files. On BURIN_OK *stroke may have any value, null included;
   * the host passes it to evaluate and end. On failure the brush must leave nothing open. context is that of
   * an empty stroke; numbers in params have stride 0 and are the values before input dynamics.
   * [stroke-thread, brush created] */
  burin_status(BURIN_CALL* begin)(const struct burin_brush* brush, const burin_stroke_context* context,
                                  const burin_params* params, burin_stroke_plan* plan, void** stroke,
                                  burin_text* error);

  /* Computes the outputs of every element of the batch and changes nothing else.
   * [any thread, concurrent, between begin and end] */
  burin_status(BURIN_CALL* evaluate)(const struct burin_brush* brush, void* stroke,
                                     const burin_stroke_context* context, const burin_batch* batch,
                                     const burin_outputs* outputs, burin_text* error);

  /* Ends a stroke whose begin returned BURIN_OK, whether or not evaluate failed since.
   * [stroke-thread, after the last evaluate] */
  void(BURIN_CALL* end)(const struct burin_brush* brush, void* stroke);
} burin_brush;

#ifdef __cplusplus
}
#endif
#endif
