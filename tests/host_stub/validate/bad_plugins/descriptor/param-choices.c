/* Has two choices of one id. */
#define CHOICES "round", "round"
#include "../good.h"
