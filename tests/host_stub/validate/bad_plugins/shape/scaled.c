/* Has a height in units of space. */
#define AT_NODE AT(outputs->up, i) /= AT(batch->radius, i)
#include "../good.h"
