/* Waits for ever. */
#include <unistd.h>
#define AT_NODE \
  for (;;) sleep(1000)
#include "../good.h"
