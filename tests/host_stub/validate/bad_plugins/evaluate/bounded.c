/* Moves nodes very far where the batch is of a certain size. */
#define AT_NODE \
  if (batch->count == 1999) AT(outputs->up, i) *= 1e6f
#include "../good.h"
