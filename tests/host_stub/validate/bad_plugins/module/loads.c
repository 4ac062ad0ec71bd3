/* Is made for another ABI. */
#define MAJOR 999
#include "../good.h"
