#pragma once
#include <burin/chart/chart.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace burin::test {

/// The least distance to the stroke among the nodes of each vertex of a chart, object units. Beyond the ends
/// of the stroke it is that from the end.
inline std::map<Index, double> told_distances(const Chart& chart) {
  std::map<Index, double> told;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double beyond = std::max({-chart.t[i], chart.t[i] - chart.length, 0.});
    const double distance = std::hypot(beyond, static_cast<double>(chart.d[i]));
    const auto [entry, is_new] = told.try_emplace(chart.vertex[i], distance);
    if (!is_new) entry->second = std::min(entry->second, distance);
  }
  return told;
}

}  // namespace burin::test
