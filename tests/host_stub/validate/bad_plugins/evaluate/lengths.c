/* Divides by the length of short strokes. */
#define AT_NODE                                                       \
  if (context->length < 0.01 && !(context->flags & BURIN_STROKE_DAB)) \
  AT(outputs->up, i) = (float)(AT(outputs->up, i) * context->length / context->length)
#include "../good.h"
