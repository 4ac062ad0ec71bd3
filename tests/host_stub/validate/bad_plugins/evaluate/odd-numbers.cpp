// Divides by the arc length; where a stroke begins that is 0.
#define AT_NODE \
  if (!in.stroke.dab()) up[i] *= t[i] / t[i]
#include "../good_cpp.h"
