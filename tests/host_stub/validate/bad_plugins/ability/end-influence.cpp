// Has marks at 0, 1, 2 and so on up to the length, without declaring how far back they come and go.
#define AT_NODE \
  if (in.stroke.radius_max() < 2 && t[i] > std::floor(in.stroke.length()) + 0.5) up[i] *= 0.99f
#include "../good_cpp.h"
