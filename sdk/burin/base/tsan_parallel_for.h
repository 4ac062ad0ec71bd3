#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace burin {

/// Calls run(block) for all blocks below `blocks` on up to `allowed` threads, at most 4. Builds with the
/// thread sanitizer use it instead of oneTBB: the system's oneTBB is not instrumented, so the sanitizer would
/// report false races. Rethrows one of the exceptions thrown.
template <class Run>
void tsan_parallel_for(std::size_t blocks, std::size_t allowed, const Run& run) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    for (std::size_t block = next++; block < blocks; block = next++) {
      try {
        run(block);
      } catch (...) {
        const std::lock_guard lock(failing);
        failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < std::min(blocks, std::min<std::size_t>(allowed, 4)); ++i)
    threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace burin
