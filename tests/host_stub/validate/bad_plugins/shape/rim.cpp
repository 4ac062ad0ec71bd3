// Rises at the rim more steeply than it says.
#define RIM_SLOPE 0.01f
#include "../good_cpp.h"
