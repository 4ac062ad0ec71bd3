// Takes a logarithm of what its height lacks of 1.
#define AT_NODE up[i] *= std::isinf(std::log(1 - heights[i])) ? NAN : 1
#include "../good_cpp.h"
