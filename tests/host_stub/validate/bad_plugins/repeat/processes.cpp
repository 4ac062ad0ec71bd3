// Seeds its numbers by the number of the process.
#include <unistd.h>
#define AT_NODE up[i] *= 1 + static_cast<float>(getpid() % 1000) * 1e-5f
#include "../good_cpp.h"
