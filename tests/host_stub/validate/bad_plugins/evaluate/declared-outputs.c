/* Writes a mask though it declares none. */
#define AT_NODE \
  if (outputs->mask.data) AT(outputs->mask, i) = 0.5f
#include "../good.h"
