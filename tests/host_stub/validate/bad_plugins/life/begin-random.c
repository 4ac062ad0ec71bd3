/* Divides by what its count lacks of 5. */
#define AT_NODE         \
  AT(outputs->up, i) *= \
      (5 - AT(batch->params->values[1].number, i)) / (5 - AT(batch->params->values[1].number, i))
#include "../good.h"
