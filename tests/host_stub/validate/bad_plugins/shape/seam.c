/* Has a step where closed strokes close. */
#define AT_NODE \
  if (context->flags & BURIN_STROKE_CLOSED) AT(outputs->up, i) += 0.01f * AT(batch->t, i)
#include "../good.h"
