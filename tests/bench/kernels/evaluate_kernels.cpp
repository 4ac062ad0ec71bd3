// The stock brushes over whole charts, batch by batch on one thread.
#include <benchmark/benchmark.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/host/brush_library.h>
#include <burin/host/plugin/param_snapshot.h>
#include <burin/services/stamp_services.h>

#include <algorithm>
#include <stdexcept>

#include "sphere_stroke.h"

namespace burin::kernels {
namespace {

constexpr std::size_t batch_size = 1024;

/// The inputs and outputs of the stock brushes, one number per node.
struct Columns {
  explicit Columns(const SphereStroke& stroke) : radius(static_cast<float>(stroke.radius)) {
    const Chart chart = StrokeChartBuilder(stroke.surface).chart(stroke.curve, {.radius = stroke.radius});
    for (const double each : chart.t) t.push_back(static_cast<float>(each));
    d = chart.d;
    up.resize(d.size());
    unused.resize(batch_size);
  }

  burin_batch batch(std::size_t begin, std::size_t count, const burin_params& params) const {
    burin_batch batch{};
    batch.struct_size = sizeof(batch);
    batch.count = static_cast<std::uint32_t>(count);
    batch.params = &params;
    batch.t = {t.data() + begin, 1, 0};
    batch.d = {d.data() + begin, 1, 0};
    batch.radius = {&radius, 0, 0};
    return batch;
  }

  burin_outputs outputs(std::size_t begin, std::size_t count) {
    burin_outputs outputs{};
    outputs.struct_size = sizeof(outputs);
    outputs.count = static_cast<std::uint32_t>(count);
    outputs.along = outputs.across = {unused.data(), 1, 0};
    outputs.up = {up.data() + begin, 1, 0};
    return outputs;
  }

  float radius;
  std::vector<float> t, d, up, unused;
};

burin_stroke_context context_of(const SphereStroke& stroke) {
  burin_stroke_context context{};
  context.struct_size = sizeof(context);
  context.flags = BURIN_STROKE_FINAL;
  context.length = stroke.curve.length();
  context.radius_min = context.radius_max = stroke.radius;
  context.object_scale = stroke.surface.scale;
  return context;
}

void evaluate_all(const BrushStroke& brush, const burin_stroke_context& context, Columns& columns) {
  for (std::size_t begin = 0; begin < columns.t.size(); begin += batch_size) {
    const std::size_t count = std::min(batch_size, columns.t.size() - begin);
    const burin_batch batch = columns.batch(begin, count, brush.params());
    if (brush.evaluate(context, batch, columns.outputs(begin, count), nullptr) != BURIN_OK)
      throw std::runtime_error("the brush fails");
  }
}

void evaluate(benchmark::State& state, const char* id, const ParamSettings& settings) {
  const SphereStroke& stroke = sphere_stroke(static_cast<std::size_t>(state.range(0)));
  Columns columns(stroke);
  BrushLibrary library(nullptr, stamp_services());
  library.load_folder(BURIN_BRUSHES);
  const BrushEntry& entry = library.find(id);
  const BrushPtr brush = library.create(entry);
  const ParamSnapshot params(*entry.descriptor, settings);
  const burin_stroke_context context = context_of(stroke);
  const BrushStroke brush_stroke(*brush, *entry.descriptor, context, params.abi());
  for ([[maybe_unused]] const auto _ : state) {
    evaluate_all(brush_stroke, context, columns);
    benchmark::ClobberMemory();
  }
  if (std::ranges::all_of(columns.up, [](float up) { return up == 0; }))
    throw std::runtime_error("the brush does nothing");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(columns.t.size()));
}
BENCHMARK_CAPTURE(evaluate, groove, "org.burin.groove", ParamSettings{})
    ->ArgName("nodes")
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000);
BENCHMARK_CAPTURE(evaluate, scales, "org.burin.scales",
                  ParamSettings{{"stamp", std::string(BURIN_SAMPLES "/stamps/scales.exr")}})
    ->ArgName("nodes")
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000);

}  // namespace
}  // namespace burin::kernels
