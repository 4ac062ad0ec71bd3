/* Keeps the seed of the batch before. */
#include <stdint.h>
static uint64_t last = 42;
#define IN_EVALUATE                                          \
  if (batch->count == 2000) {                                \
    if (last != context->seed) outputs->up.data[0] += 1e-3f; \
    last = context->seed;                                    \
  }
#include "../good.h"
