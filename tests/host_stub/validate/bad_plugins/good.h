/* A brush that keeps to the ABI, with places where plugins of this folder put their fault: macros that they
 * define before they include it. */
#ifndef BURIN_TESTS_GOOD_H
#define BURIN_TESTS_GOOD_H

#include <burin/abi/ext/bench_budget.h>
#include <burin/abi/ext/curve_filter.h>
#include <burin/abi/ext/state.h>
#include <burin/abi/ext/volume.h>
#include <burin/abi/plugin.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifndef ID
#define ID "org.example.good"
#endif
#ifndef NAME
#define NAME "Good"
#endif
#ifndef VERSION
#define VERSION "1.0.0"
#endif
#ifndef FEATURE
#define FEATURE "procedural"
#endif
#ifndef INPUTS
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS)
#endif
#ifndef OUTPUTS
#define OUTPUTS BURIN_OUTPUT_DISPLACEMENT
#endif
#ifndef OVERLAP
#define OVERLAP BURIN_OVERLAP_STRONGEST
#endif
#ifndef RIM_SLOPE
#define RIM_SLOPE 1
#endif
#ifndef PARAM_COUNT
#define PARAM_COUNT 6
#endif
/* Members of the parameters that come last and win. */
#ifndef HEIGHT
#define HEIGHT
#endif
#ifndef COUNT
#define COUNT
#endif
#ifndef PROFILE
#define PROFILE
#endif
#ifndef CHOICES
#define CHOICES "round", "flat"
#endif
#ifndef CURVE
#define CURVE
#endif
#ifndef KNOTS
#define KNOTS 0, 0, 1, 1
#endif
/* Statements. */
#ifndef IN_INIT
#define IN_INIT
#endif
#ifndef IN_DEINIT
#define IN_DEINIT
#endif
#ifndef IN_CREATE
#define IN_CREATE
#endif
#ifndef IN_BEGIN
#define IN_BEGIN
#endif
#ifndef IN_END
#define IN_END
#endif
#ifndef IN_EVALUATE
#define IN_EVALUATE
#endif
#ifndef AT_NODE
#define AT_NODE
#endif
#ifndef IN_SAVE
#define IN_SAVE
#endif
#ifndef IN_LOAD
#define IN_LOAD
#endif
#ifndef IN_PLAN_SOLID
#define IN_PLAN_SOLID
#endif
#ifndef IN_REACH
#define IN_REACH
#endif
#ifndef IN_DISTANCE
#define IN_DISTANCE
#endif
#ifndef AT_POINT
#define AT_POINT
#endif
/* Expressions. */
#ifndef OTHER_FACTORY
#define OTHER_FACTORY NULL
#endif
#ifndef OTHER_EXTENSION
#define OTHER_EXTENSION NULL
#endif
#ifndef KNOWS
#define KNOWS(brush_id) (strcmp(brush_id, ID) == 0)
#endif
#ifndef COST
#define COST 1e6
#endif
#ifndef PASSES
#define PASSES 1
#endif
#ifndef FREE
#define FREE free
#endif
#ifndef LAST_DEINIT
#define LAST_DEINIT (--users == 0)
#endif

#define AT(array, i) (array).data[(size_t)(i) * (array).stride]

typedef struct good_brush {
  burin_brush abi;
  uint32_t state;
} good_brush;

static const float knots[] = {KNOTS};
static const char* const choices[] = {CHOICES, NULL};
static const char* const features[] = {FEATURE, NULL};
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverride-init"
static const burin_param_info height = {.struct_size = sizeof(burin_param_info),
                                        .type = BURIN_PARAM_FLOAT,
                                        .id = "height",
                                        .name = "Height",
                                        .unit = BURIN_UNIT_RADIUS,
                                        .hard_max = 1,
                                        .soft_max = 1,
                                        .default_number = 0.25f,
                                        .dynamic = 1,
                                        HEIGHT};
static const burin_param_info count_param = {.struct_size = sizeof(burin_param_info),
                                             .type = BURIN_PARAM_INT,
                                             .id = "count",
                                             .name = "Count",
                                             .unit = BURIN_UNIT_NONE,
                                             .hard_max = 9,
                                             .soft_max = 9,
                                             .default_number = 3,
                                             COUNT};
static const burin_param_info profile = {.struct_size = sizeof(burin_param_info),
                                         .type = BURIN_PARAM_CHOICE,
                                         .id = "profile",
                                         .name = "Profile",
                                         .unit = BURIN_UNIT_NONE,
                                         .choices = choices,
                                         PROFILE};
static const burin_param_info curve = {.struct_size = sizeof(burin_param_info),
                                       .type = BURIN_PARAM_CURVE,
                                       .id = "curve",
                                       .name = "Curve",
                                       .unit = BURIN_UNIT_NONE,
                                       .default_knots = knots,
                                       .default_knot_count = sizeof knots / sizeof *knots / 2,
                                       CURVE};
static const burin_param_info text_param = {.struct_size = sizeof(burin_param_info),
                                            .type = BURIN_PARAM_TEXT,
                                            .id = "text",
                                            .name = "Text",
                                            .unit = BURIN_UNIT_NONE};
static const burin_param_info file_param = {.struct_size = sizeof(burin_param_info),
                                            .type = BURIN_PARAM_FILE,
                                            .id = "file",
                                            .name = "File",
                                            .unit = BURIN_UNIT_NONE,
                                            .default_file = ""};
#pragma GCC diagnostic pop
static const burin_param_info* const params[] = {&height, &count_param, &profile,
                                                 &curve,  &text_param,  &file_param};
static const burin_brush_descriptor descriptor = {.struct_size = sizeof descriptor,
                                                  .param_count = PARAM_COUNT,
                                                  .id = ID,
                                                  .name = NAME,
                                                  .vendor = "Example",
                                                  .version = VERSION,
                                                  .features = features,
                                                  .params = params,
                                                  .inputs_read = INPUTS,
                                                  .outputs_written = OUTPUTS,
                                                  .overlap = OVERLAP,
                                                  .rim_slope = RIM_SLOPE};
static const burin_brush_descriptor* const brushes[] = {&descriptor};

static void say(burin_text* text, const char* line) {
  if (!text || text->capacity == 0) return;
  const size_t most = text->capacity - 1, size = strlen(line) < most ? strlen(line) : most;
  memcpy(text->data, line, size);
  text->data[size] = 0;
}

static burin_status BURIN_CALL save(const burin_brush* brush, void* data, uint64_t capacity, uint64_t* size,
                                    burin_text* error) {
  good_brush* self = brush->self;
  *size = 4;
  say(error, "the buffer is too small");
  IN_SAVE;
  if (capacity < 4) return BURIN_INVALID_ARGUMENT;
  memcpy(data, &self->state, 4);
  return BURIN_OK;
}

static burin_status BURIN_CALL load(const burin_brush* brush, uint32_t version, const void* data,
                                    uint64_t size, burin_text* error) {
  good_brush* self = brush->self;
  IN_LOAD;
  say(error, "no such state");
  if (version != 1) return BURIN_UNSUPPORTED;
  if (size != 4) return BURIN_ERROR;
  memcpy(&self->state, data, 4);
  return BURIN_OK;
}

static burin_status BURIN_CALL plan_solid(const burin_brush* brush, void* stroke,
                                          const burin_stroke_context* context, const burin_params* values,
                                          burin_solid_plan* plan, burin_text* error) {
  (void)brush, (void)stroke, (void)values, (void)error;
  plan->h_min = 0;
  plan->h_max = plan->detail = context->radius_max * 0.1;
  IN_PLAN_SOLID;
  return BURIN_OK;
}

static burin_status BURIN_CALL distance(const burin_brush* brush, void* stroke,
                                        const burin_stroke_context* context, const burin_batch* batch,
                                        burin_floats h, burin_floats_out out, burin_text* error) {
  (void)brush, (void)stroke, (void)context, (void)error;
  for (uint32_t i = 0; i < batch->count; ++i) AT(out, i) = fabsf(AT(h, i)) - 0.1f;
  IN_DISTANCE;
  return BURIN_OK;
}

static void BURIN_CALL reach(const burin_brush* brush, void* stroke, burin_curve_reach* out) {
  (void)brush, (void)stroke;
  out->behind = out->ahead = 0;
  IN_REACH;
}

static burin_status BURIN_CALL filter(const burin_brush* brush, void* stroke,
                                      const burin_stroke_context* context, const burin_params* values,
                                      const burin_curve_points* points, burin_floats_out along,
                                      burin_floats_out across, burin_text* error) {
  (void)brush, (void)stroke, (void)context, (void)values, (void)along, (void)error;
  for (uint32_t i = 0; i < points->count; ++i) {
    AT(across, i) = 0.1f;
    AT_POINT;
  }
  return BURIN_OK;
}

static double BURIN_CALL evaluate_cost(const burin_brush* brush, const burin_params* values) {
  (void)brush, (void)values;
  return COST;
}

static const burin_state state = {sizeof state, 1, save, load};
static const burin_volume volume = {sizeof volume, 0, plan_solid, distance};
static const burin_curve_filter curve_filter = {sizeof curve_filter, 0, reach, filter};
static const burin_bench_budget budget = {sizeof budget, 0, evaluate_cost};

static const void* BURIN_CALL get_extension(const burin_brush* brush, const char* id) {
  (void)brush;
  if (strcmp(id, BURIN_EXT_STATE) == 0) return &state;
  if (strcmp(id, BURIN_EXT_VOLUME) == 0) return &volume;
  if (strcmp(id, BURIN_EXT_CURVE_FILTER) == 0) return &curve_filter;
  if (strcmp(id, BURIN_EXT_BENCH_BUDGET) == 0) return &budget;
  return OTHER_EXTENSION;
}

static burin_status BURIN_CALL begin(const burin_brush* brush, const burin_stroke_context* context,
                                     const burin_params* values, burin_stroke_plan* plan, void** stroke,
                                     burin_text* error) {
  (void)brush, (void)context, (void)values, (void)error;
  *stroke = malloc(64);
  plan->passes = PASSES;
  IN_BEGIN;
  return BURIN_OK;
}

static burin_status BURIN_CALL evaluate(const burin_brush* brush, void* stroke,
                                        const burin_stroke_context* context, const burin_batch* batch,
                                        const burin_outputs* outputs, burin_text* error) {
  (void)brush, (void)stroke, (void)context, (void)error;
  for (uint32_t i = 0; i < batch->count; ++i) {
    const float d = AT(batch->d, i), radius = AT(batch->radius, i), rim = 1 - d * d / (radius * radius);
    float up = AT(batch->params->values[0].number, i) * radius * (rim > 0 ? rim * rim : 0);
    if (!(context->flags & BURIN_STROKE_CLOSED)) {
      const float t = AT(batch->t, i), before = t < 0 ? -t / radius : 0,
                  in_cap = 1 - before * before - d * d / (radius * radius);
      if (before > 0)
        up = AT(batch->params->values[0].number, i) * radius * (in_cap > 0 ? in_cap * in_cap : 0);
      const float after = (t - (float)context->length) / radius,
                  in_end = 1 - after * after - d * d / (radius * radius);
      if (after > 0)
        up = AT(batch->params->values[0].number, i) * radius * (in_end > 0 ? in_end * in_end : 0);
    }
    AT(outputs->up, i) = up;
    AT_NODE;
  }
  IN_EVALUATE;
  return BURIN_OK;
}

static void BURIN_CALL end(const burin_brush* brush, void* stroke) {
  (void)brush;
  IN_END;
  FREE(stroke);
}

static void BURIN_CALL destroy(const burin_brush* brush) { free(brush->self); }

static const burin_brush* BURIN_CALL create(const burin_brush_factory* factory, const burin_host* host,
                                            const char* brush_id, burin_text* error) {
  (void)factory, (void)host;
  IN_CREATE;
  if (!KNOWS(brush_id)) return say(error, "no such brush"), NULL;
  good_brush* self = malloc(sizeof *self);
  self->abi = (burin_brush){sizeof(burin_brush), 0, self, destroy, get_extension, begin, evaluate, end};
  self->state = 7;
  return &self->abi;
}

static const burin_brush_factory factory = {sizeof factory, 1, brushes, create};
static int users;

static burin_status BURIN_CALL init(const char* plugin_path, burin_text* error) {
  (void)plugin_path, (void)error;
  ++users;
  IN_INIT;
  return BURIN_OK;
}

static void BURIN_CALL deinit(void) {
  if (LAST_DEINIT) {
    IN_DEINIT;
  }
}

static const void* BURIN_CALL get_factory(const char* id) {
  return users > 0 && strcmp(id, BURIN_BRUSH_FACTORY) == 0 ? (const void*)&factory : OTHER_FACTORY;
}

#ifndef MAJOR
#define MAJOR BURIN_ABI_MAJOR
#endif
const burin_plugin_entry burin_plugin = {sizeof burin_plugin, MAJOR, BURIN_ABI_MINOR, 0, init, deinit,
                                         get_factory};

#endif
