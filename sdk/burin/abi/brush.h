/* burin/abi/brush.h - a brush: its descriptor, its life, its evaluation.
 *
 * A brush is a pointwise function over the stroke chart. It never sees the mesh; what it needs of a
 * node's surroundings it declares as an input. Life of a brush and of its strokes:
 *
 *   create -> { begin -> evaluate* -> end }* -> destroy
 *
 * Several strokes of one brush may be open at once, each with a `stroke` of its own; evaluate may run
 * on many threads at once for one stroke. A stroke is a pure function of context, parameters and
 * batch: the host may evaluate nodes in any split and order, and again whenever it likes.
 */
#ifndef BURIN_ABI_BRUSH_H
#define BURIN_ABI_BRUSH_H

#include "host.h"
#include "stroke.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What holds at a place that a stroke visits several times, crossing itself, coming back, as a row of dabs,
 * in pieces, or in its symmetric images: how what the brush does in each of these sheets becomes one. But
 * for strongest and add, which take all of every sheet, sheets fade in over the outer three quarters of their
 * half width, so that nothing jumps where one begins. */
typedef int32_t burin_overlap;
enum {
  BURIN_OVERLAP_UNKNOWN = 0,   /* the brush does not say: as strongest */
  BURIN_OVERLAP_STRONGEST = 1, /* the highest rise and the deepest cut; of colours and masks the most cover */
  BURIN_OVERLAP_LATEST = 2,    /* the sheet drawn last lies on top: for patterns, which do not mix */
  BURIN_OVERLAP_MAX = 3,       /* the sheet that moves the place farthest outward; the most of a colour */
  BURIN_OVERLAP_MIN = 4,       /* the one that moves it farthest inward; the least */
  BURIN_OVERLAP_ADD = 5,       /* the sum */
  BURIN_OVERLAP_AVERAGE = 6    /* the mean */
};

/* Owned by the plugin; lives from init to deinit. Ids and texts are UTF-8. */
typedef struct burin_brush_descriptor {
  uint32_t struct_size;
  uint32_t param_count;
  const char* id;   /* reverse DNS, "org.burin.groove": never changes */
  const char* name; /* for people */
  const char* vendor;
  const char* version;                   /* of the brush, "1.2.0" */
  const char* help;                      /* one or two sentences; may be null */
  const char* const* features;           /* tags such as "procedural", "stamp"; ended by a null pointer */
  const burin_param_info* const* params; /* param_count pointers; their order is that of burin_params */
  uint64_t inputs_read;                  /* BURIN_INPUT_* */
  uint64_t outputs_written;              /* BURIN_OUTPUT_* */
  burin_overlap overlap;                 /* since 1.1: default strongest; users may choose another */
  uint32_t reserved;                     /* since 1.1: 0 */
} burin_brush_descriptor;

/* What a stroke needs of the host, told at begin() since it may follow from the parameters.
 * The host sets struct_size and the defaults; the brush changes what differs. */
typedef struct burin_stroke_plan {
  uint32_t struct_size;
  uint32_t passes;      /* >= 1, default 1: evaluate runs over the whole stroke once a pass, and inputs
                           (position, laplacian, displacement) are those after the pass before */
  double end_influence; /* how far back from the end (object units, >= 0, default 0) the result depends
                           on context.length or BURIN_STROKE_FINAL; infinity is allowed. When either
                           changes, the host evaluates anew all nodes with
                           t > (length before) - end_influence, round cap included */
} burin_stroke_plan;

typedef struct burin_brush {
  uint32_t struct_size;
  uint32_t reserved;
  void* self; /* the plugin's own */

  /* Frees the brush. [main-thread, no stroke open] */
  void(BURIN_CALL* destroy)(const struct burin_brush* brush);

  /* The brush's optional ability with this id ("burin.NAME/1", see ext/), or null. Lives as long as the
   * brush. [any thread, concurrent] */
  const void*(BURIN_CALL* get_extension)(const struct burin_brush* brush, const char* id);

  /* Begins a stroke: checks parameters, opens files. On BURIN_OK *stroke may be anything, also null; it
   * is handed to evaluate and end. On failure nothing stays open. context is that of an empty stroke;
   * numbers in params have stride 0 and are the values before input dynamics.
   * [stroke-thread, brush created] */
  burin_status(BURIN_CALL* begin)(const struct burin_brush* brush, const burin_stroke_context* context,
                                  const burin_params* params, burin_stroke_plan* plan, void** stroke,
                                  burin_text* error);

  /* Computes the outputs of every element of the batch; touches nothing else.
   * [any thread, concurrent, between begin and end] */
  burin_status(BURIN_CALL* evaluate)(const struct burin_brush* brush, void* stroke,
                                     const burin_stroke_context* context, const burin_batch* batch,
                                     const burin_outputs* outputs, burin_text* error);

  /* Ends a stroke that began, in success and failure alike. [stroke-thread, after the last evaluate] */
  void(BURIN_CALL* end)(const struct burin_brush* brush, void* stroke);
} burin_brush;

#ifdef __cplusplus
}
#endif
#endif
