/* Divides by what its height lacks of 1. */
#define AT_NODE         \
  AT(outputs->up, i) *= \
      (1 - AT(batch->params->values[0].number, i)) / (1 - AT(batch->params->values[0].number, i))
#include "../good.h"
