/* Takes the radius of the first node for all. */
#define AT_NODE AT(outputs->up, i) *= AT(batch->radius, 0) / AT(batch->radius, i)
#include "../good.h"
