/* Forgets memory with every brush. */
#define IN_CREATE             \
  static void* kept;          \
  void** block = malloc(100); \
  *block = kept;              \
  kept = block
#include "../good.h"
