// Names a feature as if it were the ABI's.
#define FEATURES "burin.pretty"
#include "../good_cpp.h"
