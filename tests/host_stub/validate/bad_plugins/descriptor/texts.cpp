// Has a name that no list has room for.
#define NAME "The brush that raises a smooth ridge along the stroke and whatever its author may think of next"
#include "../good_cpp.h"
