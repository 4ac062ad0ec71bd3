/* Is lower near the ends, without declaring how far back that matters: hosts give it 0 everywhere. */
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_END_DISTANCE)
#define AT_NODE AT(outputs->up, i) *= AT(batch->end_distance, i) > 0 ? 1 : 0.99f
#include "../good.h"
