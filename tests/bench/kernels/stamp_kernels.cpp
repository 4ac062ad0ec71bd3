// Stamp samples through the service that brushes have.
#include <benchmark/benchmark.h>
#include <burin/abi/ext/stamps.h>
#include <burin/host/plugin/services.h>
#include <burin/services/stamp_services.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace burin::kernels {
namespace {

constexpr std::uint32_t batch = 1024;

/// Places in rows of nodes, as batches of a chart have them: 64 to a tile.
void fill_places(std::vector<float>& u, std::vector<float>& v) {
  for (std::uint32_t i = 0; i < batch; ++i) {
    u.push_back(static_cast<float>(i % 64) / 64 + 0.3F * std::sin(static_cast<float>(i)) / 64);
    v.push_back(static_cast<float>(i) / (64 * 64) + 0.3F * std::cos(static_cast<float>(i)) / 64);
  }
}

void stamp_samples(benchmark::State& state) {
  const HostServices services(nullptr, stamp_services());
  const burin_host* host = services.abi();
  const auto& stamps = *static_cast<const burin_stamps*>(host->get_extension(host, BURIN_EXT_STAMPS));
  burin_stamp stamp{};
  if (stamps.open(host, BURIN_SAMPLES "/stamps/scales.exr", &stamp, nullptr, nullptr) != BURIN_OK)
    throw std::runtime_error("cannot open the sample stamp");
  std::vector<float> u, v, values(batch);
  fill_places(u, v);
  for ([[maybe_unused]] const auto _ : state) {
    stamps.sample(host, stamp, 0, batch, {u.data(), 1, 0}, {v.data(), 1, 0}, {values.data(), 1, 0});
    benchmark::ClobberMemory();
  }
  stamps.close(host, stamp);
  state.SetItemsProcessed(state.iterations() * batch);
}
BENCHMARK(stamp_samples);

}  // namespace
}  // namespace burin::kernels
