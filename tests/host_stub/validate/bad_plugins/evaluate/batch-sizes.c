/* Counts nodes in 16 bits. */
#define AT_NODE \
  if (i >= (uint16_t)batch->count) AT(outputs->up, i) = 0
#include "../good.h"
