// Writes a text in evaluate, which the library of C++ allocates.
#include <string>
#define IN_EVALUATE \
  if (std::to_string(in.size()) + " nodes, which is more than fits" == "none") up[0] = 0
#include "../good_cpp.h"
