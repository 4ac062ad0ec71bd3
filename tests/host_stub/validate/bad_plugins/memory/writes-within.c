/* Writes what is before dense outputs. */
#define IN_EVALUATE \
  if (outputs->up.stride == 1 && batch->count == 257) outputs->up.data[-1] = 0
#include "../good.h"
