// Compares every node with the next, also the last one.
#define AT_NODE \
  if (d[i + 1] > 1e30f) up[i] = 0
#include "../good_cpp.h"
