/* Allocates memory in evaluate. */
#define IN_EVALUATE                    \
  void* volatile scratch = malloc(64); \
  free(scratch)
#include "../good.h"
