/* Has a parameter of a type that there is not. */
#define COUNT .type = 77
#include "../good.h"
