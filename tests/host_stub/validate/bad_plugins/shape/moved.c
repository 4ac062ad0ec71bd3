/* Looks at places in space without saying so. */
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_NORMAL)
#define AT_NODE AT(outputs->up, i) *= 1 - 0.5f * AT(batch->normal.z, i)
#include "../good.h"
