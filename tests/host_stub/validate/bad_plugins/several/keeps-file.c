/* Leaves the file open that each stroke opens. */
#include <fcntl.h>
#define IN_BEGIN (void)!open("/dev/null", O_RDONLY)
#include "../good.h"
