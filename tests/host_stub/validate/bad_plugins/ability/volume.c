/* Writes a distance that is no number. */
#define IN_DISTANCE AT(out, 5) = NAN
#include "../good.h"
