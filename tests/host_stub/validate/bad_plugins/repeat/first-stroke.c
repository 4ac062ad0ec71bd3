/* Keeps the height of the first stroke of the process for all. */
static float first_height = -1;
#define IN_BEGIN \
  if (first_height < 0) first_height = values->values[0].number.data[0]
#define AT_NODE AT(outputs->up, i) *= 1 + first_height
#include "../good.h"
