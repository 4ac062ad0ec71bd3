// Looks upwards in space without saying so.
#define MORE_INPUTS BURIN_INPUT_NORMAL
#define AT_NODE up[i] *= 1 - 0.5f * in.normal().z[i]
#include "../good_cpp.h"
