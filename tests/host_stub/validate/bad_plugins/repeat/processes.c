/* Shades strokes by the number of the process. */
#include <unistd.h>
#define IN_BEGIN *(int*)*stroke = getpid() % 1000
#define AT_NODE AT(outputs->up, i) *= 1 + (float)*(int*)stroke * 1e-5f
#include "../good.h"
