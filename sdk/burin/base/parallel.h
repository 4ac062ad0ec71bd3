#pragma once
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cstddef>

namespace burin {

/// Calls body(begin, end) for blocks that together cover [0, count), each at most `grain` long, on all
/// threads. The blocks are the same for any number of threads; bodies must not depend on each other.
template <class Body>
void parallel_blocks(std::size_t count, std::size_t grain, const Body& body) {
  const std::size_t blocks = (count + grain - 1) / grain;
  // Orders what comes before the loop, its bodies and what comes after in the sight of race detectors too,
  // which do not see into the system's oneTBB.
  std::atomic<std::size_t> done;
  done.store(0, std::memory_order_release);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const auto& range) {
    done.load(std::memory_order_acquire);
    for (std::size_t block = range.begin(); block != range.end(); ++block) {
      const std::size_t begin = block * grain;
      body(begin, begin + grain < count ? begin + grain : count);
    }
    done.fetch_add(1, std::memory_order_acq_rel);
  });
  done.load(std::memory_order_acquire);
}

/// While it lives, loops of this process run on at most this many threads.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads)
      : control_(tbb::global_control::max_allowed_parallelism, threads) {}

 private:
  tbb::global_control control_;
};

}  // namespace burin
