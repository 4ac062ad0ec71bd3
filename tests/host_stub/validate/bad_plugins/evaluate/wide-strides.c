/* Takes a stride of 3 for 1. */
#define AT_NODE \
  if (batch->d.stride == 3) AT(outputs->up, i) = batch->d.data[i] * 0.1f
#include "../good.h"
