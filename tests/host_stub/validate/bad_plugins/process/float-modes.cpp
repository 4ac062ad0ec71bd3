// Lets the processor flush denormals from its first stroke on.
#include <xmmintrin.h>
#define IN_BEGIN _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON)
#include "../good_cpp.h"
