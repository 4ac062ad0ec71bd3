#pragma once
#include <oneapi/tbb/task_arena.h>

namespace burin {

/// Calls `work`, whose loops of oneTBB have the calling thread alone: those of libraries that know no other
/// threads, where an application lends its own.
template <class Work>
auto without_workers(const Work& work) {
  tbb::task_arena alone(1);
  return alone.execute(work);
}

}  // namespace burin
