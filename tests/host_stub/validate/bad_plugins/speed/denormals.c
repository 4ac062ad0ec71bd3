/* Takes long where t is tiny. */
#define AT_NODE                                                                \
  if (AT(batch->t, i) > 0 && AT(batch->t, i) < 1e-38f && batch->count == 1024) \
    for (volatile int k = 0; k < 3000; ++k) {                                  \
    }
#include "../good.h"
