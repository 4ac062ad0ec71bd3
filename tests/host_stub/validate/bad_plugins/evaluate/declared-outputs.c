/* Writes what the mask is anyway, though it declares none. */
#define AT_NODE \
  if (outputs->mask.data) AT(outputs->mask, i) = 1
#include "../good.h"
