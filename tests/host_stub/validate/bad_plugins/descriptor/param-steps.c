/* Has a whole number with a fraction as default. */
#define COUNT .default_number = 2.5f
#include "../good.h"
