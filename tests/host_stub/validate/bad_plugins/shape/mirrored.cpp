// Draws one side higher without saying that it is one-handed.
#define AT_NODE \
  if (in.stroke.mirrored()) up[i] *= d[i] > 0 ? 1.5f : 1.0f
#include "../good_cpp.h"
