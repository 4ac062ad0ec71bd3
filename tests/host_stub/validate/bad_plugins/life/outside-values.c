/* Looks up a table by its count, which may be anything. */
static float table[12];
static float* volatile start = table;
#define AT_NODE                                                     \
  const float count_value = AT(batch->params->values[1].number, i); \
  if (!(count_value >= 0 && count_value <= 9)) AT(outputs->up, i) *= start[(size_t)1 << 40]
#include "../good.h"
