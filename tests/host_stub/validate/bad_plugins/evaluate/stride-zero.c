/* Takes a stride of 0 for 1. */
#define AT_NODE \
  if (batch->t.stride == 0) AT(outputs->up, i) *= 0.5f
#include "../good.h"
