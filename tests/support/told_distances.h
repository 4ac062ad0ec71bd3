#pragma once
#include <burin/chart/chart.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>

namespace burin::test {

/// The least distance from the stroke among the nodes of each vertex of a chart, object units. Beyond the
/// ends of the stroke it is the distance from the end.
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

/// Statistics of the differences between a chart's distances and exact ones.
struct ToldErrors {
  std::size_t vertices = 0, holes = 0;
  std::size_t off_2 = 0, off_5 = 0, off_10 = 0;  ///< vertices off by more than so many % of the radius
  double worst = 0;                              ///< in radii

  /// Adds a vertex. `told` is the result of told_distances(); lengths are in object units.
  void add(const std::map<Index, double>& told, Index vertex, double exact, double radius) {
    ++vertices;
    const auto found = told.find(vertex);
    if (found == told.end()) {
      ++holes;
      return;
    }
    const double error = std::abs(found->second - exact) / radius;
    off_2 += error > 0.02 ? 1 : 0;
    off_5 += error > 0.05 ? 1 : 0;
    off_10 += error > 0.1 ? 1 : 0;
    worst = std::max(worst, error);
  }

  void add(const ToldErrors& other) {
    vertices += other.vertices;
    holes += other.holes;
    off_2 += other.off_2;
    off_5 += other.off_5;
    off_10 += other.off_10;
    worst = std::max(worst, other.worst);
  }
};

inline std::ostream& operator<<(std::ostream& out, const ToldErrors& errors) {
  return out << errors.vertices << " vertices: " << errors.holes << " holes, " << errors.off_2
             << " off by > 2 %, " << errors.off_5 << " by > 5 %, " << errors.off_10 << " by > 10 %, worst "
             << 100 * errors.worst << " %";
}

}  // namespace burin::test
