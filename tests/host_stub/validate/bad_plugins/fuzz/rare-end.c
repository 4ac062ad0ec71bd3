/* Looks at the length without declaring how far back, where it is high. */
#define AT_NODE \
  if (AT(batch->params->values[0].number, i) > 0.5f) AT(outputs->up, i) /= 1 + (float)context->length
#include "../good.h"
