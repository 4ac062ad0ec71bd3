/* Fills all of a reach, whatever there is. */
#define IN_REACH memset((char*)out + 8, 0, out->struct_size - 8)
#include "../good.h"
