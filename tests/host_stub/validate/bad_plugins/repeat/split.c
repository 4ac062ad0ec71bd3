/* Shades nodes by the size of small batches. */
#define AT_NODE                                                                                       \
  if (batch->count < 250 && batch->count > 100 && context->length == 10 && context->radius_max < 2 && \
      !context->flags)                                                                                \
  AT(outputs->up, i) *= 1.01f
#include "../good.h"
