/* Looks up a table by t without a look at its range. */
static float table[12];
static float* volatile start = table;
#define AT_NODE \
  if (AT(batch->t, i) > 1e30f) AT(outputs->up, i) *= start[(size_t)1 << 40]
#include "../good.h"
