/* Sleeps as it is initialised for the first time. */
#include <threads.h>
static int slept;
#define IN_INIT \
  if (!slept++) thrd_sleep(&(struct timespec){.tv_nsec = 200000000}, 0)
#include "../good.h"
