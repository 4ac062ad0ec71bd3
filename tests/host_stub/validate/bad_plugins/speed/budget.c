/* Promises more than it keeps. */
#define COST 1e-6
#include "../good.h"
