/* Has an id that is no reverse DNS name. */
#define ID "good"
#include "../good.h"
