// Takes the share of the length that a node has, where a dab has no length.
#define AT_NODE \
  if (in.stroke.dab()) up[i] *= t[i] / static_cast<float>(in.stroke.length())
#include "../good_cpp.h"
