#pragma once
#include <ctime>

namespace burin::test {

/// The processor's time, of all threads of this program, that `work` takes.
template <class Work>
double processor_seconds(const Work& work) {
  const std::clock_t before = std::clock();
  work();
  return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

}  // namespace burin::test
