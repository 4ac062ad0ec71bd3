// Keeps an interim result in the brush, and computes for a while before it is used.
#include <atomic>
static std::atomic<int> steps;
#define MEMBERS mutable volatile float interim_ = 0
#define AT_NODE                                             \
  interim_ = up[i];                                         \
  for (int step = 0; step < 100; ++step) steps.store(step); \
  up[i] = interim_
#include "../good_cpp.h"
