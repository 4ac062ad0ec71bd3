/* Reads an input that the ABI does not have. */
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | (UINT64_C(1) << 60))
#include "../good.h"
