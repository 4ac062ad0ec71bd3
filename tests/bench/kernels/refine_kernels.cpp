// Measures the way from a cage to a surface on which strokes can be drawn.
#include <benchmark/benchmark.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include "measure.h"

namespace burin::kernels {
namespace {

void cage_to_surface(benchmark::State& state) {
  const PolygonMesh cage = read_mesh(BURIN_SAMPLES "/meshes/ewer.obj");
  std::vector<double> refining, making, indexing;
  std::size_t triangles = 0;
  run_and_count(state, [&] {
    TriangleMesh mesh;
    Surface surface;
    refining.push_back(
        seconds_of([&] { mesh = refine(cage, natural_scheme(cage), static_cast<int>(state.range(0))); }));
    making.push_back(seconds_of([&] { surface = make_surface(std::move(mesh)); }));
    indexing.push_back(seconds_of([&] { const Picker picker(surface); }));
    triangles = surface.triangles.size();
    return refining.back() + making.back() + indexing.back();
  });
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["refine ms"] = 1e3 * median(refining);
  state.counters["surface ms"] = 1e3 * median(making);
  state.counters["search tree ms"] = 1e3 * median(indexing);
  state.counters["all/refine"] = (median(refining) + median(making) + median(indexing)) / median(refining);
}
BENCHMARK(cage_to_surface)
    ->ArgName("levels")
    ->DenseRange(3, 6)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin::kernels
