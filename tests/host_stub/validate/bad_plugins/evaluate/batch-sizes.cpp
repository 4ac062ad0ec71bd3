// Has room for 1024 nodes, and notices others by an exception that nobody catches.
#include <exception>
#define IN_EVALUATE \
  if (in.size() > 1024) std::terminate()
#include "../good_cpp.h"
