/* Reads a node beyond the batch. */
#define IN_EVALUATE                                                              \
  volatile float beyond = batch->d.data[(size_t)batch->count * batch->d.stride]; \
  (void)beyond
#include "../good.h"
