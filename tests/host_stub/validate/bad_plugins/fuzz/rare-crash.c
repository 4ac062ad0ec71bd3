/* Falls over closed strokes with high counts. */
#define IN_EVALUATE \
  if ((context->flags & BURIN_STROKE_CLOSED) && AT(batch->params->values[1].number, 0) > 6) abort()
#include "../good.h"
