// Waves with a period that does not divide the length of closed strokes.
#define AT_NODE \
  if (in.stroke.closed()) up[i] *= 1 + 0.5f * math::sin(t[i])
#include "../good_cpp.h"
