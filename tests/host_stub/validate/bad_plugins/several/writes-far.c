/* Writes as if a batch had 100,000 nodes more. */
#define IN_EVALUATE \
  for (uint32_t far = 0; far < 100000; ++far) AT(outputs->up, batch->count + far) = 0
#include "../good.h"
