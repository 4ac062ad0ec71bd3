/* Has a default beyond its range. */
#define COUNT .default_number = 10
#include "../good.h"
