#pragma once
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace burin {

/// A reusable barrier for threads that wait for each other for times far shorter than a scheduler's time
/// slice. It spins first and then yields.
class StepBarrier {
 public:
  explicit StepBarrier(std::size_t threads) : threads_(threads) {}

  void arrive_and_wait() {
    const std::size_t step = step_.load(std::memory_order_relaxed);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
      arrived_.store(0, std::memory_order_relaxed);
      step_.store(step + 1, std::memory_order_release);
      return;
    }
    constexpr int spins = 20000;
    for (int i = 0; step_.load(std::memory_order_acquire) == step; ++i)
      if (i > spins) std::this_thread::yield();
  }

 private:
  std::size_t threads_;
  std::atomic<std::size_t> arrived_{0}, step_{0};
};

/// Calls body(i) for i in [0, count) concurrently, each on a thread of its own (body(0) on the caller's), so
/// that bodies may wait for each other. Starting threads pays off for work of milliseconds. If a body throws
/// or a thread cannot be started, the process ends, since the other bodies would wait forever.
template <class Body>
void run_concurrently(std::size_t count, const Body& body) noexcept {
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < count; ++i) others.emplace_back([&body, i] { body(i); });
  body(0);
}

}  // namespace burin
