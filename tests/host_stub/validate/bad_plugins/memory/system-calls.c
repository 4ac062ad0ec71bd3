/* Reads a file in evaluate. */
#include <fcntl.h>
#include <unistd.h>
#define IN_EVALUATE                             \
  const int file = open("/dev/null", O_RDONLY); \
  close(file)
#include "../good.h"
