/* Keeps what it computes in an input that it has no other use for. */
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_MEAN_CURVATURE)
#define AT_NODE                                                                               \
  ((float*)(uintptr_t)batch->mean_curvature.data)[(size_t)i * batch->mean_curvature.stride] = \
      AT(outputs->up, i)
#include "../good.h"
