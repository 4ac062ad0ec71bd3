#pragma once
#include <chrono>
#include <utility>

namespace burin {

/// Wall time, for reports.
class Stopwatch {
 public:
  /// Seconds since the last lap(), or since construction.
  double elapsed() const { return seconds(Clock::now() - last_); }

  /// The same; the next lap begins.
  double lap() {
    const Clock::time_point now = Clock::now();
    return seconds(now - std::exchange(last_, now));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

  Clock::time_point last_ = Clock::now();
};

}  // namespace burin
