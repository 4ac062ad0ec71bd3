// Merges the results of recordings, and formats the figures of the whole replay as JSON and as text.
#include "replay/replay_summary.h"

#include <burin/base/hash.h>
#include <burin/host/percentile.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/figures.h"

namespace burin {
namespace {

double vertices_per_second(const ReplayResult& result) {
  const auto sum = [](const std::vector<double>& seconds) {
    return std::accumulate(seconds.begin(), seconds.end(), 0.0);
  };
  const double seconds = sum(result.latencies) + sum(result.end_latencies);
  return seconds > 0 ? static_cast<double>(result.vertices_changed) / seconds : 0;
}

double memory_per_vertex(const ReplaySummary& summary) {
  return static_cast<double>(summary.peak_memory) / static_cast<double>(summary.surface_vertices);
}

}  // namespace

void add_result(ReplaySummary& summary, ReplayResult result) {
  ReplayResult& sum = summary.result;
  sum.strokes += result.strokes;
  sum.left_open += result.left_open;
  sum.standing_clocks += result.standing_clocks;
  sum.pieces += result.pieces;
  sum.samples_drawn += result.samples_drawn;
  sum.samples_off_surface += result.samples_off_surface;
  sum.vertices_changed += result.vertices_changed;
  sum.hash = result.hash;
  sum.end_latencies.insert(sum.end_latencies.end(), result.end_latencies.begin(), result.end_latencies.end());
  sum.latencies.insert(sum.latencies.end(), result.latencies.begin(), result.latencies.end());
  std::sort(sum.latencies.begin(), sum.latencies.end());
}

Json summary_json(const ReplaySummary& summary) {
  const ReplayResult& result = summary.result;
  return {{"files", summary.files},
          {"strokes", result.strokes},
          {"pieces", result.pieces},
          {"events", result.samples_drawn},
          {"events_off_surface", result.samples_off_surface},
          {"latency_ms", percentiles_json(in_milliseconds(percentiles(result.latencies)))},
          {"vertices_changed", result.vertices_changed},
          {"vertices_per_second", vertices_per_second(result)},
          {"peak_memory_bytes", summary.peak_memory},
          {"peak_memory_bytes_per_vertex", memory_per_vertex(summary)},
          {"seconds_to_first_event", summary.seconds_to_first_event},
          {"result_hash", hash_text(result.hash)}};
}

std::string summary_text(const ReplaySummary& summary) {
  const ReplayResult& result = summary.result;
  const Percentiles latency = percentiles(result.latencies);
  return fmt::format(
      "strokes         {} in {} pieces, {} events ({} more off the surface)\n"
      "event latency   p50 {:.2f} ms, p95 {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n"
      "throughput      {:.3g} vertices a second\n"
      "peak memory     {:.0f} MB, {:.0f} bytes a vertex\n"
      "to first event  {:.2f} s\n"
      "result hash     {}\n",
      result.strokes, result.pieces, result.samples_drawn, result.samples_off_surface, 1e3 * latency.p50,
      1e3 * latency.p95, 1e3 * latency.p99, 1e3 * latency.max, vertices_per_second(result),
      static_cast<double>(summary.peak_memory) / 1e6, memory_per_vertex(summary),
      summary.seconds_to_first_event, hash_text(result.hash));
}

}  // namespace burin
