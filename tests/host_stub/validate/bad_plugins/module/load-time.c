/* Sleeps as it is initialised for the first time. */
#include <unistd.h>
static int slept;
#define IN_INIT \
  if (!slept++) usleep(200000)
#include "../good.h"
