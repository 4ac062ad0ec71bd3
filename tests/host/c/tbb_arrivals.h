#pragma once
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>

#include <atomic>
#include <chrono>

namespace burin::test {

/// An arena of four threads of this program's oneTBB, on any machine, which counts how often workers come to
/// it. Workers that are still on their way to loops of another arena are not counted.
class CountedArena {
 public:
  CountedArena() : arena_(4), arrivals_(arena_) {}

  /// Workers that came while `work` ran, whose loops have the threads of this arena.
  template <class Work>
  int arrivals_during(const Work& work) {
    const int before = arrivals_.count;
    arena_.execute(work);
    return arrivals_.count - before;
  }

  /// Whether a worker comes to `work`, which is repeated for at most half a minute.
  template <class Work>
  bool arrive_at(const Work& work) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end)
      if (arrivals_during(work) > 0) return true;
    return false;
  }

 private:
  class Arrivals : public tbb::task_scheduler_observer {
   public:
    explicit Arrivals(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) { observe(true); }
    ~Arrivals() override { observe(false); }
    void on_scheduler_entry(bool is_worker) override { count += is_worker; }
    std::atomic<int> count = 0;
  };

  tbb::global_control four_{tbb::global_control::max_allowed_parallelism, 4};
  tbb::task_arena arena_;
  Arrivals arrivals_;
};

}  // namespace burin::test
