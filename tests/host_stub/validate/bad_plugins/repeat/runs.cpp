// Draws numbers from a generator that goes on and on, so that every comparison fails.
#include <random>
static std::minstd_rand generator;
#define AT_NODE up[i] *= 1 + 1e-3f * static_cast<float>(generator() % 100)
#include "../good_cpp.h"
