// Takes the height of the first node for all.
#define AT_NODE up[i] += heights[0] - heights[i]
#include "../good_cpp.h"
