/* Reads the pressure without declaring it. */
#define AT_NODE                                     \
  volatile float pressure = AT(batch->pressure, i); \
  (void)pressure
#include "../good.h"
