// Exports a function besides its entry.
extern "C" __attribute__((visibility("default"))) int helper() { return 1; }
#include "../good_cpp.h"
