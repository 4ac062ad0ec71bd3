/* Rises as it says near the rim, and more steeply farther inside. */
#define RIM_SLOPE 0.15f
#include "../good.h"
