#pragma once
#include <burin/base/task_runner.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>
#include <functional>

#if defined(__SANITIZE_THREAD__)
#include <burin/base/tsan_parallel_for.h>
#endif

namespace burin {

/// The number of threads that parallel loops of this thread may use now.
inline std::size_t thread_count() {
  if (const TaskRunner* runner = TaskRunner::current()) return runner->threads();
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

/// Calls body(begin, end) for consecutive blocks of [0, count), each at most `grain` long, on all threads.
/// The blocks are the same for any number of threads; the calls must be independent of each other.
template <class Body>
void parallel_blocks(std::size_t count, std::size_t grain, const Body& body) {
  const std::size_t blocks = (count + grain - 1) / grain;
  const auto run = [&](std::size_t block) {
    const std::size_t begin = block * grain;
    body(begin, begin + grain < count ? begin + grain : count);
  };
  if (const TaskRunner* runner = TaskRunner::current()) return runner->run(blocks, run);
#if defined(__SANITIZE_THREAD__)
  tsan_parallel_for(blocks, thread_count(), run);
#else
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const auto& range) {
    for (std::size_t block = range.begin(); block != range.end(); ++block) run(block);
  });
#endif
}

/// The number of threads that may be started beside those of loops: none where an application lends its own.
inline std::size_t own_thread_count() { return TaskRunner::current() ? 1 : thread_count(); }

/// Sorts on all threads, or on the caller's where an application lends its own. Elements that compare equal
/// must be identical, since their order is not defined.
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator first, Iterator last, const Less& less = {}) {
#if defined(__SANITIZE_THREAD__)
  std::sort(first, last, less);
#else
  if (TaskRunner::current())
    std::sort(first, last, less);
  else
    tbb::parallel_sort(first, last, less);
#endif
}

/// Limits the threads of parallel loops in this process during its lifetime.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads)
      : control_(tbb::global_control::max_allowed_parallelism, threads) {}

 private:
  tbb::global_control control_;
};

}  // namespace burin
