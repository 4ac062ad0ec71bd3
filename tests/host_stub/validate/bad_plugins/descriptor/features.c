/* Has a feature in the name of the ABI. */
#define FEATURE "burin.best-brush"
#include "../good.h"
