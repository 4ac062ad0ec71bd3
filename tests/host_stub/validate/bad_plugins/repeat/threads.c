/* Computes in a place that threads share, slowly enough for another thread to come between. */
static volatile float shared;
#define AT_NODE                                   \
  shared = AT(outputs->up, i);                    \
  for (volatile int wait = 0; wait < 300; ++wait) \
    ;                                             \
  AT(outputs->up, i) = shared
#include "../good.h"
