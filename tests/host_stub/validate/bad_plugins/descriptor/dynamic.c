/* Has a curve that varies along the stroke. */
#define CURVE .dynamic = 1
#include "../good.h"
