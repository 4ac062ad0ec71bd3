/* Returns an interface for every id. */
#define OTHER_EXTENSION &state
#include "../good.h"
