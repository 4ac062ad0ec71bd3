// Keeps the height of the last stroke in one place for all.
static float last_height = 0.25f;
#define IN_BEGIN last_height = start.params[height].value()
#define AT_NODE \
  if (heights[i] != last_height) up[i] = 0
#include "../good_cpp.h"
