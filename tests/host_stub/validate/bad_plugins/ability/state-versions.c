/* Takes states of every version. */
#define IN_LOAD \
  if (size == 4) return memcpy(&self->state, data, 4), BURIN_OK
#include "../good.h"
