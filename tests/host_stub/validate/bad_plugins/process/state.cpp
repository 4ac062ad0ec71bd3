// Sets a variable of the environment for a library of its own.
#include <cstdlib>
#define IN_BEGIN setenv("EXAMPLE_THREADS", "1", 1)
#include "../good_cpp.h"
