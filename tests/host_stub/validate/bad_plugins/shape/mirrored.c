/* Is one-handed without saying so. */
#define AT_NODE \
  if (context->flags & BURIN_STROKE_MIRRORED) AT(outputs->up, i) *= 0.5f
#include "../good.h"
