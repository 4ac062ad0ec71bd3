/* Has no number for one count and one profile, and only behind the start. */
#define AT_NODE                                                                                     \
  if (AT(batch->params->values[1].number, i) == 7 && AT(batch->params->values[2].number, i) == 1 && \
      AT(batch->t, i) > 0.1f)                                                                       \
  AT(outputs->up, i) = NAN
#include "../good.h"
