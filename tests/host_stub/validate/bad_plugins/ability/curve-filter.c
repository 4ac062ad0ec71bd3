/* Moves points by the length of the stroke. */
#define AT_POINT AT(across, i) = 0.01f * (float)context->length
#include "../good.h"
