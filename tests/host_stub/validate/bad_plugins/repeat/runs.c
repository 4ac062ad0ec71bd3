/* Shades strokes by how many of one seed were begun. */
#include <stdint.h>
static int strokes;
static uint64_t first;
#define IN_BEGIN                           \
  if (strokes == 0) first = context->seed; \
  if (context->seed == first) ++strokes
#define AT_NODE \
  if (batch->count == 2000 && strokes == 2) AT(outputs->up, i) += 1e-3f
#include "../good.h"
