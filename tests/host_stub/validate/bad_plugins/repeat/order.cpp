// Smooths over nodes that follow each other.
#define MORE_INPUTS BURIN_INPUT_NODE_ID
#define AT_NODE \
  if (i > 0 && in.node_id()[i] < in.node_id()[i - 1]) up[i] += 1e-3f
#include "../good_cpp.h"
