// Reads an input that it does not declare, which the C++ layer refuses.
#define IN_EVALUATE (void)in.pressure()
#include "../good_cpp.h"
