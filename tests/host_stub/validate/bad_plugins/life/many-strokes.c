/* Keeps what belongs to a stroke in one place for all. */
static int begun;
#define IN_BEGIN \
  ++begun;       \
  *(int*)*stroke = begun
#define IN_END --begun
#define AT_NODE \
  if (begun > 2) AT(outputs->up, i) *= 0.5f
#include "../good.h"
