/* Creates no other brush, and does not say why. */
#define IN_CREATE \
  if (strcmp(brush_id, ID) != 0) return NULL
#include "../good.h"
