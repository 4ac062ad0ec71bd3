/* Divides by its height. */
#define AT_NODE         \
  AT(outputs->up, i) *= \
      0.25f / AT(batch->params->values[0].number, i) * AT(batch->params->values[0].number, i) * 4
#include "../good.h"
