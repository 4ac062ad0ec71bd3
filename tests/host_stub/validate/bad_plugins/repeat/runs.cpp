// Draws numbers from a generator that goes on and on.
#include <random>
static std::minstd_rand generator;
#define IN_EVALUATE \
  if (in.size() == 2000) up[0] += 1e-3f * static_cast<float>(generator() % 100)
#include "../good_cpp.h"
