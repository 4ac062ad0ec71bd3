/* Has a soft range that exceeds the hard one. */
#define COUNT .soft_max = 12
#include "../good.h"
