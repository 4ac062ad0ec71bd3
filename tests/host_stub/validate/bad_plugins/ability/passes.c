/* Writes NaN in its second pass. */
#define PASSES 2
#define IN_EVALUATE \
  if (context->pass == 1) AT(outputs->up, 0) = NAN
#include "../good.h"
