#pragma once
#include <benchmark/benchmark.h>
#include <burin/host/percentile.h>

#include <vector>

#include "bench/paper/stopwatch.h"

namespace burin::kernels {

/// Wall time of a call.
template <class Body>
double seconds_of(const Body& body) {
  paper::Stopwatch watch;
  body();
  return watch.lap();
}

inline double median(const std::vector<double>& values) { return percentiles(values).p50; }

/// Nanoseconds per item, from the median of times in seconds over `items` items.
inline double nanoseconds_each(const std::vector<double>& seconds, double items) {
  return 1e9 * median(seconds) / items;
}

/// Counts a computation by hand: as many times as the library asks for, and often enough for a median where
/// once takes long enough to it. `measure` returns the seconds that the library is to count.
template <class Measure>
void run_and_count(benchmark::State& state, const Measure& measure) {
  constexpr int least = 5;
  int runs = 0;
  for ([[maybe_unused]] const auto _ : state) {
    state.SetIterationTime(measure());
    ++runs;
  }
  for (; runs < least; ++runs) measure();
}

}  // namespace burin::kernels
