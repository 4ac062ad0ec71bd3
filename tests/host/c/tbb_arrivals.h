#pragma once
#include <oneapi/tbb/task_scheduler_observer.h>

#include <atomic>

namespace burin::test {

/// Counts the threads of this program's oneTBB that come to the loops which this thread starts.
class TbbArrivals : public tbb::task_scheduler_observer {
 public:
  TbbArrivals() { observe(true); }
  ~TbbArrivals() override { observe(false); }
  void on_scheduler_entry(bool is_worker) override { count += is_worker; }
  std::atomic<int> count = 0;
};

}  // namespace burin::test
