/* Compares each node with all others of large batches. */
#define AT_NODE                                                 \
  if (batch->count > 5000 && batch->count < 20000)              \
    for (volatile uint32_t k = 0; k < batch->count / 16; ++k) { \
    }
#include "../good.h"
