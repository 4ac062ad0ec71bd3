/* Refuses a batch larger than its own. */
#define IN_EVALUATE \
  if (batch->struct_size > sizeof *batch) return BURIN_INVALID_ARGUMENT
#include "../good.h"
