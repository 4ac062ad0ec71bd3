// Takes the share of the length that a node has, also of strokes without one.
#define AT_NODE                                      \
  if (!in.stroke.dab() && in.stroke.length() < 0.01) \
  up[i] *= static_cast<float>(in.stroke.length() / in.stroke.length())
#include "../good_cpp.h"
