/* Forgets its state when it refuses that of an older version. */
#define IN_LOAD \
  if (version == 0) return self->state = 0, BURIN_UNSUPPORTED
#include "../good.h"
