/* Has two parameters of one id. */
#define COUNT .id = "height"
#include "../good.h"
