/* Looks at the length without declaring how far back. */
#define AT_NODE \
  if (context->length > 10 && context->radius_max < 2) AT(outputs->up, i) *= 0.99f
#include "../good.h"
