/* Ends with the first of several deinits. */
#define LAST_DEINIT (users = 0, 1)
#include "../good.h"
