/* Has the number of the process in its name. */
#include <stdio.h>
#include <unistd.h>
static char name[32];
#define NAME name
#define IN_INIT snprintf(name, sizeof name, "Good %d", (int)getpid())
#include "../good.h"
