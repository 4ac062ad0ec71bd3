/* Shades nodes whose number is lower than that of the one before. */
#define INPUTS (BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_NODE_ID)
#define AT_NODE \
  if (i > 0 && AT(batch->node_id, i) < AT(batch->node_id, i - 1)) AT(outputs->up, i) += 1e-3f
#include "../good.h"
