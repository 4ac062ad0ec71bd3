/* Begins in another working directory, where its files are. */
#include <unistd.h>
#define IN_BEGIN (void)!chdir("/")
#include "../good.h"
