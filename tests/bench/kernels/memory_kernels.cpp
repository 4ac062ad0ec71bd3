// The floor: no chart is faster than its bytes move.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

namespace burin::kernels {
namespace {

/// The memory, about, that the chart reads and writes per vertex.
constexpr std::size_t bytes_per_vertex = 120;

void memory_floor(benchmark::State& state) {
  const auto vertices = static_cast<std::size_t>(state.range(0));
  // Copied bytes are touched twice.
  const std::size_t size = vertices * bytes_per_vertex / 2;
  const std::vector<char> from(size, 1);
  std::vector<char> to(size);
  for ([[maybe_unused]] const auto _ : state) {
    std::memcpy(to.data(), from.data(), size);
    benchmark::ClobberMemory();
  }
  state.counters["s/vertex"] =
      benchmark::Counter(static_cast<double>(vertices),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(memory_floor)->ArgName("vertices")->RangeMultiplier(10)->Range(1000, 1'000'000);

}  // namespace
}  // namespace burin::kernels
