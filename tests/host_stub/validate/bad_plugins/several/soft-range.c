/* Forgets the soft range of a number. */
#define COUNT .soft_max = 0
#include "../good.h"
