/* burin/plugin/c/module.h - what every plugin module in C needs besides its brush. C11.
 *
 *   static const burin_brush_descriptor descriptor = {...};
 *   static void plan(const burin_stroke_context*, const burin_params*, burin_stroke_plan*) {...}
 *   static burin_status BURIN_CALL evaluate(...) {...}
 *
 *   BURIN_C_PLUGIN(descriptor, plan, evaluate);
 *
 * `descriptor` describes the only brush. It has no memory of its own: `evaluate`, of the type of
 * burin_brush.evaluate, gets null for the stroke. `plan` may change what burin_stroke_plan has by default.
 * Values of parameters outside of their ranges are refused before it is called. BURIN_C_BUDGET, defined
 * before this header is included, promises how long evaluate takes (burin/abi/ext/bench_budget.h): at most so
 * many times what copying the declared inputs takes, whatever the parameters. Build the module with
 * burin_add_brush() of CMake: it must be named NAME.burin. A brush that makes solids has
 * burin/plugin/c/solid.h. For plugins with more brushes, memory or other extensions see burin/abi/plugin.h.
 */
#ifndef BURIN_PLUGIN_C_MODULE_H
#define BURIN_PLUGIN_C_MODULE_H

#include <burin/abi/ext/bench_budget.h>
#include <burin/abi/plugin.h>
#include <burin/plugin/c/param_ranges.h>
#include <string.h>

/* Element i of an array of a batch or of outputs. */
#define BURIN_AT(array, i) ((array).data[(size_t)(i) * (array).stride])

static inline void BURIN_CALL burin_c_destroy(const burin_brush* brush) { (void)brush; }

#ifndef BURIN_C_BUDGET
#define BURIN_C_BUDGET 0 /* promises nothing */
#endif

static inline double BURIN_CALL burin_c_evaluate_cost(const burin_brush* brush, const burin_params* params) {
  (void)brush, (void)params;
  return BURIN_C_BUDGET;
}

static inline const void* BURIN_CALL burin_c_get_extension(const burin_brush* brush, const char* id) {
  static const burin_bench_budget budget = {sizeof(burin_bench_budget), 0, burin_c_evaluate_cost};
  (void)brush;
  return BURIN_C_BUDGET > 0 && strcmp(id, BURIN_EXT_BENCH_BUDGET) == 0 ? &budget : NULL;
}

static inline void BURIN_CALL burin_c_end(const burin_brush* brush, void* stroke) {
  (void)brush, (void)stroke;
}

static inline burin_status BURIN_CALL burin_c_init(const char* plugin_path, burin_text* error) {
  (void)plugin_path, (void)error;
  return BURIN_OK;
}

static inline void BURIN_CALL burin_c_deinit(void) {}

/* Writes as much of the line as there is room for. */
static inline void burin_c_say(burin_text* text, const char* line) {
  const size_t size = strlen(line);
  if (!text || text->capacity == 0) return;
  strncpy(text->data, line, text->capacity - 1);
  text->data[size < text->capacity ? size : text->capacity - 1] = '\0';
}

/* Whether a parameter is outside of its range; the text says which. */
static inline int burin_c_refuses(const burin_brush_descriptor* brush, const burin_params* params,
                                  burin_text* error) {
  const burin_param_info* outside = burin_outside_range(brush, params);
  char line[96] = "a value is outside of its range: ";
  if (outside) burin_c_say(error, strncat(line, outside->id, 60));
  return outside != NULL;
}

#define BURIN_C_PLUGIN(descriptor, plan, evaluate) \
  BURIN_C_PLUGIN_WITH(descriptor, plan, evaluate, burin_c_get_extension)

/* Names that end in _ are the macro's own, so that authors may have all others. */
#define BURIN_C_PLUGIN_WITH(descriptor, plan, evaluate, get_extension)                                     \
  static burin_status BURIN_CALL burin_c_begin(                                                            \
      const burin_brush* brush_, const burin_stroke_context* context_, const burin_params* params_,        \
      burin_stroke_plan* plan_, void** stroke_, burin_text* error_) {                                      \
    (void)brush_;                                                                                          \
    *stroke_ = NULL;                                                                                       \
    if (burin_c_refuses(&(descriptor), params_, error_)) return BURIN_INVALID_ARGUMENT;                    \
    plan(context_, params_, plan_);                                                                        \
    return BURIN_OK;                                                                                       \
  }                                                                                                        \
  static const burin_brush burin_c_brush = {                                                               \
      sizeof(burin_brush), 0, NULL, burin_c_destroy, get_extension, burin_c_begin, evaluate, burin_c_end}; \
  static const burin_brush* BURIN_CALL burin_c_create(                                                     \
      const burin_brush_factory* factory_, const burin_host* host_, const char* id_, burin_text* error_) { \
    (void)factory_, (void)host_;                                                                           \
    if (strcmp(id_, (descriptor).id) == 0) return &burin_c_brush;                                          \
    burin_c_say(error_, "this plugin has no such brush");                                                  \
    return NULL;                                                                                           \
  }                                                                                                        \
  static const burin_brush_descriptor* const burin_c_brushes[] = {&(descriptor)};                          \
  static const burin_brush_factory burin_c_factory = {sizeof(burin_brush_factory), 1, burin_c_brushes,     \
                                                      burin_c_create};                                     \
  static const void* BURIN_CALL burin_c_get_factory(const char* id_) {                                     \
    return strcmp(id_, BURIN_BRUSH_FACTORY) == 0 ? &burin_c_factory : NULL;                                \
  }                                                                                                        \
  const burin_plugin_entry burin_plugin = {                                                                \
      sizeof(burin_plugin_entry), BURIN_ABI_MAJOR, BURIN_ABI_MINOR, 0, burin_c_init, burin_c_deinit,       \
      burin_c_get_factory}

#endif
