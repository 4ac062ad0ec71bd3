/* Computes in a place that threads share. */
#include <sched.h>
static volatile float shared;
#define AT_NODE                   \
  shared = AT(outputs->up, i);    \
  if (i % 16 == 0) sched_yield(); \
  AT(outputs->up, i) = shared
#include "../good.h"
