/* Refuses a curve of a newer host. */
#define AT_POINT \
  if (points->struct_size > sizeof *points) return BURIN_UNSUPPORTED
#include "../good.h"
