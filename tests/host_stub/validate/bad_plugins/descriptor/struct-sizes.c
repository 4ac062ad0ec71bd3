/* Forgets the size of a parameter. */
#define HEIGHT .struct_size = 0
#include "../good.h"
