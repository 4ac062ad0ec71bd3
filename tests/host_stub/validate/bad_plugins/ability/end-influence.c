/* Has marks at 0, 1, 2 and so on up to the length, without declaring how far back they come and go. */
#define AT_NODE \
  if (context->radius_max < 2 && AT(batch->t, i) > floor(context->length) + 0.5) AT(outputs->up, i) *= 0.99f
#include "../good.h"
