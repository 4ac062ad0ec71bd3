/* Has a default outside of its range, which it refuses. */
#define HEIGHT .default_number = 25
#define IN_BEGIN                                         \
  if (AT(values->values[0].number, 0) > 1) {             \
    free(*stroke);                                       \
    return say(error, "height"), BURIN_INVALID_ARGUMENT; \
  }
#include "../good.h"
