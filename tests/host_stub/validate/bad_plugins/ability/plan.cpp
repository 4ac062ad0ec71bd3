// Asks for no pass.
#define IN_BEGIN start.passes = 0
#include "../good_cpp.h"
