/* burin/plugin/c/compositing.h - colours laid over those of the surface.
 *
 * The fourth number of a colour is how much of the surface it covers. Where nothing is painted that is 0, and
 * red, green and blue, 1 each, mean nothing. A brush that mixed each of the four numbers by itself would
 * leave a fringe of that white; the functions here do not. They may be called on any thread.
 */
#ifndef BURIN_PLUGIN_C_COMPOSITING_H
#define BURIN_PLUGIN_C_COMPOSITING_H

#include <burin/abi/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Lays an ink, linear RGBA, over the colour of element i of an output by the operator "over" [Porter and Duff
 * 1984]. `share` (0..1) says how much of the ink there is: 0 leaves the colour as it is. */
static inline void burin_composite_over(const burin_floats_out colour[4], uint32_t i, const float ink[4],
                                        float share) {
  float* rgba[4];
  for (int k = 0; k < 4; ++k) rgba[k] = colour[k].data + (size_t)i * colour[k].stride;
  const float above = share * ink[3], below = *rgba[3] * (1 - above), whole = above + below;
  if (!(above > 0) || !(whole > 0)) return;
  for (int k = 0; k < 3; ++k) *rgba[k] = (ink[k] * above + *rgba[k] * below) / whole;
  *rgba[3] = whole < 1 ? whole : 1;
}

#ifdef __cplusplus
}
#endif
#endif
