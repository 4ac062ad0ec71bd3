/* Divides by the length of a dab. */
#define AT_NODE \
  if (context->flags & BURIN_STROKE_DAB) AT(outputs->up, i) /= (float)context->length
#include "../good.h"
