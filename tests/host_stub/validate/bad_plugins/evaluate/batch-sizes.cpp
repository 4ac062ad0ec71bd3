// Counts nodes in 16 bits.
#define AT_NODE \
  if (i >= static_cast<std::uint16_t>(in.size())) up[i] = 0
#include "../good_cpp.h"
