/* burin/plugin/c/solid.h - a plugin in C with one brush that makes solids, burin/abi/ext/volume.h.
 *
 *   static void solid(const burin_stroke_context* stroke, const burin_params* values,
 *                     burin_solid_plan* solid);
 *   static float distance(const burin_stroke_context* stroke, const burin_batch* in, uint32_t i, float h);
 *   BURIN_C_SOLID_PLUGIN(descriptor, plan, evaluate, solid, distance);
 *
 * `descriptor`, `plan` and `evaluate` are those of BURIN_C_PLUGIN in module.h. `solid` says between which
 * heights the solid of a finished stroke lies and how fine it is; struct_size is set, all else zero.
 * `distance` returns the signed distance to the solid at point i of a batch and the height h, object units,
 * negative inside; it is called on any thread, on several at once.
 */
#ifndef BURIN_PLUGIN_C_SOLID_H
#define BURIN_PLUGIN_C_SOLID_H

#include <burin/abi/ext/volume.h>
#include <burin/plugin/c/module.h>
#include <math.h>

/* The length of (x, y), with the bits of math::hypot() in C++. */
static inline float burin_hypot(float x, float y) { return (float)sqrt((double)x * x + (double)y * y); }

#define BURIN_C_SOLID_PLUGIN(descriptor, plan, evaluate, solid, distance)                                \
  static burin_status BURIN_CALL burin_c_solid_plan(                                                     \
      const burin_brush* brush_, void* stroke_, const burin_stroke_context* context_,                    \
      const burin_params* params_, burin_solid_plan* plan_, burin_text* error_) {                        \
    (void)brush_, (void)stroke_, (void)error_;                                                           \
    solid(context_, params_, plan_);                                                                     \
    return BURIN_OK;                                                                                     \
  }                                                                                                      \
  static burin_status BURIN_CALL burin_c_distance(                                                       \
      const burin_brush* brush_, void* stroke_, const burin_stroke_context* context_,                    \
      const burin_batch* batch_, burin_floats h_, burin_floats_out out_, burin_text* error_) {           \
    (void)brush_, (void)stroke_, (void)error_;                                                           \
    for (uint32_t i_ = 0; i_ < batch_->count; ++i_)                                                      \
      BURIN_AT(out_, i_) = distance(context_, batch_, i_, BURIN_AT(h_, i_));                             \
    return BURIN_OK;                                                                                     \
  }                                                                                                      \
  static const void* BURIN_CALL burin_c_get_solid(const burin_brush* brush_, const char* id_) {          \
    static const burin_volume volume_ = {sizeof(burin_volume), 0, burin_c_solid_plan, burin_c_distance}; \
    return strcmp(id_, BURIN_EXT_VOLUME) == 0 ? &volume_ : burin_c_get_extension(brush_, id_);           \
  }                                                                                                      \
  BURIN_C_PLUGIN_WITH(descriptor, plan, evaluate, burin_c_get_solid)

#endif
