// Vertex normals of a stroke's region anew, as every event of a stroke has them computed.
#include <benchmark/benchmark.h>
#include <burin/base/parallel.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/surface/geometry/normals.h>

#include "sphere_stroke.h"

namespace burin::kernels {
namespace {

void normals(benchmark::State& state) {
  const SphereStroke& stroke = sphere_stroke(static_cast<std::size_t>(state.range(0)));
  const Chart chart = StrokeChartBuilder(stroke.surface).chart(stroke.curve, {.radius = stroke.radius});
  const ThreadLimit limit(static_cast<std::size_t>(state.range(1)));
  std::vector<Vec3f> result(stroke.surface.vertex_count());
  for ([[maybe_unused]] const auto _ : state) {
    update_normals(stroke.surface, stroke.surface.positions, chart.vertex, result);
    benchmark::ClobberMemory();
  }
  state.counters["vertices/s"] =
      benchmark::Counter(static_cast<double>(chart.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(normals)
    ->ArgNames({"vertices", "threads"})
    ->ArgsProduct({{1000, 10'000, 100'000, 1'000'000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin::kernels
