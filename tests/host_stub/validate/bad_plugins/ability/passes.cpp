// Writes no number in its second pass.
#define IN_BEGIN start.passes = 2
#define AT_NODE \
  if (in.stroke.pass() == 1) up[i] = NAN
#include "../good_cpp.h"
