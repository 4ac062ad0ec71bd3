/* Keeps the values that begin gets, instead of what they say. */
#include <burin/abi/param.h>
static const burin_params* kept;
#define IN_BEGIN kept = values
#define AT_NODE \
  if (kept->count != 6) AT(outputs->up, i) = 0
#include "../good.h"
