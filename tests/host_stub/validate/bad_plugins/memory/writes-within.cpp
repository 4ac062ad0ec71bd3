// Clears what comes after dense outputs.
#define IN_EVALUATE \
  if (&up[1] - &up[0] == 1 && in.size() == 257) up[in.size()] = 0
#include "../good_cpp.h"
