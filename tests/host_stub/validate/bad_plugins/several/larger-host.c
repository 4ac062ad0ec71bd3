/* Wants to know all of its host. */
#define IN_CREATE \
  if (host->struct_size > sizeof *host) return NULL
#include "../good.h"
