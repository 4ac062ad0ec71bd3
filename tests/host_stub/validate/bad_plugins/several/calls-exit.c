/* Ends the process of the host. */
#define IN_EVALUATE exit(0)
#include "../good.h"
