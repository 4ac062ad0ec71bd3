/* burin/plugin/c/param_ranges.h - values of parameters outside of their ranges. Hosts pass none; the begin of
 * module.h, and that of brushes in C++, refuses those of a host that does.
 */
#ifndef BURIN_PLUGIN_C_PARAM_RANGES_H
#define BURIN_PLUGIN_C_PARAM_RANGES_H

#include <burin/abi/brush.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The greatest value of a number; the least is that of FLOAT and INT, of others 0. */
static inline float burin_param_greatest(const burin_param_info* info) {
  float count = 0;
  if (info->type == BURIN_PARAM_FLOAT || info->type == BURIN_PARAM_INT) return info->hard_max;
  if (info->type != BURIN_PARAM_CHOICE) return 1;
  while (info->choices && info->choices[(size_t)count]) ++count;
  return count - 1;
}

/* Whether a number is finite and within the range of its parameter. */
static inline int burin_in_range(const burin_param_info* info, float number) {
  const int has_range = info->type == BURIN_PARAM_FLOAT || info->type == BURIN_PARAM_INT;
  return number - number == 0 && number >= (has_range ? info->hard_min : 0) &&
         number <= burin_param_greatest(info);
}

/* The first parameter whose value, as begin gets it, is outside of its range; null if there is none. */
static inline const burin_param_info* burin_outside_range(const burin_brush_descriptor* brush,
                                                          const burin_params* params) {
  const uint32_t count = params && params->count < brush->param_count ? params->count : brush->param_count;
  for (uint32_t i = 0; params && i < count; ++i) {
    const burin_param_info* info = brush->params[i];
    const burin_param_value* value = &params->values[i];
    const int colour = info->type == BURIN_PARAM_COLOUR;
    if (info->type < BURIN_PARAM_FLOAT || info->type > BURIN_PARAM_COLOUR) continue;
    for (int k = 0; k < (colour ? 4 : 1); ++k) {
      const burin_floats* number = colour ? &value->colour[k] : &value->number;
      if (number->data && !burin_in_range(info, number->data[0])) return info;
    }
  }
  return NULL;
}

#ifdef __cplusplus
}
#endif
#endif
