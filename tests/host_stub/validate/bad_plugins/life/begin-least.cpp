// Divides by its height.
#define AT_NODE up[i] *= heights[i] / heights[i]
#include "../good_cpp.h"
