// Writes heights as if units were thousandths; it does not say how steeply it rises from the rim.
#define RIM_SLOPE 0
#define AT_NODE up[i] *= 1e5f
#include "../good_cpp.h"
