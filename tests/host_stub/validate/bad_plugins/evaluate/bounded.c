/* Moves every thousandth vertex very far; it does not say how steeply it rises from the rim. */
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_NODE_ID)
#define RIM_SLOPE 0
#define AT_NODE \
  if (AT(batch->node_id, i) % 1000 == 999) AT(outputs->up, i) *= 1e6f
#include "../good.h"
