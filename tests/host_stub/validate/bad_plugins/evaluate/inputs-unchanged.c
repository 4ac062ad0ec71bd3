/* Writes into an input. */
#define IN_EVALUATE \
  if (batch->count == 500) ((float*)(uintptr_t)batch->t.data)[batch->count - 1] = 0
#include "../good.h"
