/* Waits for ever where a closed stroke has more of a count. */
#include <unistd.h>
#define AT_NODE \
  while ((context->flags & BURIN_STROKE_CLOSED) && AT(batch->params->values[1].number, 0) > 6) pause()
#include "../good.h"
