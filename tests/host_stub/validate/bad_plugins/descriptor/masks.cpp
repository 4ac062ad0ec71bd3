// Reads an input that there is not.
#define MORE_INPUTS UINT64_C(1) << 40
#include "../good_cpp.h"
