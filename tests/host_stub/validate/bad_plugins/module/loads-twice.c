/* Refuses to be in a process twice. */
#define _GNU_SOURCE
#include <stdlib.h>
#define IN_INIT                                         \
  if (users == 1) {                                     \
    if (getenv("ORG_EXAMPLE_GOOD")) return BURIN_ERROR; \
    setenv("ORG_EXAMPLE_GOOD", "1", 1);                 \
  }
#define IN_DEINIT unsetenv("ORG_EXAMPLE_GOOD")
#include "../good.h"
