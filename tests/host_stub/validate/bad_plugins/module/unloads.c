/* Leaves a file open. */
#include <fcntl.h>
#define IN_INIT (void)!open("/dev/null", O_RDONLY)
#include "../good.h"
