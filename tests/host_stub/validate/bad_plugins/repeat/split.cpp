// Computes with the first node of the batch.
#define AT_NODE                                                                                       \
  if (in.size() < 250 && in.size() > 100 && in.stroke.length() == 10 && in.stroke.radius_max() < 2 && \
      !in.stroke.closed())                                                                            \
  up[i] += 1e-3f * t[0]
#include "../good_cpp.h"
