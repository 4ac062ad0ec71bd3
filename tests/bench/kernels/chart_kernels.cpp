// Whole charts by size of their region, order and threads. What they are compared with is measured in turn
// with them, so that whatever slows the machine down slows both.
#include <benchmark/benchmark.h>
#include <burin/base/parallel.h>
#include <burin/chart/stroke_chart_builder.h>

#include "bare_dijkstra.h"
#include "measure.h"
#include "sphere_stroke.h"

namespace burin::kernels {
namespace {

const std::vector<std::int64_t> region_sizes = {1000, 10'000, 100'000, 1'000'000};

const SphereStroke& stroke_of(const benchmark::State& state) {
  return sphere_stroke(static_cast<std::size_t>(state.range(0)));
}

/// Measures charts and Dijkstra's algorithm in turn.
template <class Prepare>
void measure_charts(benchmark::State& state, const SphereStroke& stroke, const SurfaceCurve& curve,
                    StrokeChartBuilder& builder, const ChartOptions& options, const Prepare& prepare) {
  BareDijkstra dijkstra(stroke.surface);
  std::vector<double> chart_seconds, dijkstra_seconds;
  double nodes = 0, vertices = 0;
  run_and_count(state, [&] {
    prepare();
    Chart chart;
    chart_seconds.push_back(seconds_of([&] { chart = builder.chart(curve, options); }));
    nodes = static_cast<double>(chart.size());
    dijkstra_seconds.push_back(seconds_of([&] {
      vertices = static_cast<double>(dijkstra.run(stroke.curve, static_cast<float>(stroke.radius)).size());
    }));
    return chart_seconds.back();
  });
  const double chart_each = nanoseconds_each(chart_seconds, nodes);
  const double dijkstra_each = nanoseconds_each(dijkstra_seconds, vertices);
  state.counters["nodes"] = nodes;
  state.counters["ns/node"] = chart_each;
  // Distances along edges are longer than those of the chart, so that fewer vertices lie within the radius.
  state.counters["dijkstra vertices"] = vertices;
  state.counters["dijkstra ns/vertex"] = dijkstra_each;
  state.counters["chart/dijkstra"] = median(chart_seconds) / median(dijkstra_seconds);
  state.counters["node/dijkstra vertex"] = chart_each / dijkstra_each;
}

void whole_chart(benchmark::State& state) {
  const SphereStroke& stroke = stroke_of(state);
  const ThreadLimit limit(static_cast<std::size_t>(state.range(2)));
  StrokeChartBuilder builder(stroke.surface);
  const ChartOptions options{.radius = stroke.radius, .order = static_cast<int>(state.range(1))};
  measure_charts(state, stroke, stroke.curve, builder, options, [] {});
}
BENCHMARK(whole_chart)
    ->Name("chart")
    ->ArgNames({"nodes", "order", "threads"})
    ->ArgsProduct({region_sizes, {1, 2}, {1, 2}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// Measures a chart over a base surface, including the computation of its nodes.
void base_chart(benchmark::State& state) {
  const SphereStroke& stroke = stroke_of(state);
  const ThreadLimit limit(static_cast<std::size_t>(state.range(1)));
  const SurfaceLevels levels(stroke.surface);
  StrokeChartBuilder builder(stroke.surface, &levels);
  const ChartOptions options{.radius = stroke.radius, .follow = 0};
  builder.begin(options);
  const SurfaceCurve curve = on_base(stroke, builder.base());
  // Nodes are forgotten when the radius changes.
  measure_charts(state, stroke, curve, builder, options,
                 [&] { builder.begin({.radius = 2 * stroke.radius, .follow = 0}); });
}
BENCHMARK(base_chart)
    ->ArgNames({"nodes", "threads"})
    ->ArgsProduct({region_sizes, {1, 2}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

void chart_speedup(benchmark::State& state) {
  const SphereStroke& stroke = stroke_of(state);
  StrokeChartBuilder builder(stroke.surface);
  const auto seconds_on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return seconds_of(
        [&] { benchmark::DoNotOptimize(builder.chart(stroke.curve, {.radius = stroke.radius}).size()); });
  };
  std::vector<double> one, two;
  run_and_count(state, [&] {
    one.push_back(seconds_on(1));
    two.push_back(seconds_on(2));
    return two.back();
  });
  state.counters["one/two threads"] = median(one) / median(two);
}
BENCHMARK(chart_speedup)
    ->ArgName("nodes")
    ->ArgsProduct({region_sizes})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin::kernels
