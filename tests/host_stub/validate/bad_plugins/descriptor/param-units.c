/* Has a choice with a unit. */
#define PROFILE .unit = BURIN_UNIT_ANGLE
#include "../good.h"
