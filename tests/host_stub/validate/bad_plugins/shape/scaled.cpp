// Has a height in units of space.
#define AT_NODE up[i] /= radius[i]
#include "../good_cpp.h"
