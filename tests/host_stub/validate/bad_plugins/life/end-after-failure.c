/* Frees the stroke when a batch fails. */
#define IN_EVALUATE                                                                      \
  if (isnan(AT(batch->d, 0)) && isnan(AT(batch->t, 0)) && isnan(AT(batch->radius, 0))) { \
    free(stroke);                                                                        \
    return BURIN_ERROR;                                                                  \
  }
#include "../good.h"
