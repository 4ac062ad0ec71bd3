/* Has a slider without an end. */
#include <math.h>
#define HEIGHT .hard_max = INFINITY, .soft_max = INFINITY
#include "../good.h"
