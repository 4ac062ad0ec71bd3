#include <burin/deform/stroke_changes.h>

#include <cstddef>

namespace burin {
namespace {

bool same_inputs(const StrokeNodes& a, std::size_t i, const StrokeNodes& b, std::size_t j) {
  if (a.chart.t[i] != b.chart.t[j] || a.chart.d[i] != b.chart.d[j] || a.chart.e1[i] != b.chart.e1[j])
    return false;
  return a.pen.empty() || a.pen[i] == b.pen[j];
}

}  // namespace

StrokeChanges find_changes(const StrokeNodes& before, const StrokeNodes& now, double end_zone) {
  StrokeChanges changes;
  const std::vector<Index>& old = before.chart.vertex;
  std::size_t i = 0;
  for (std::size_t j = 0; j < now.chart.size(); ++j) {
    const Index vertex = now.chart.vertex[j];
    for (; i < old.size() && old[i] < vertex; ++i) changes.left.push_back(old[i]);
    const bool known = i < old.size() && old[i] == vertex;
    if (!known || now.chart.t[j] >= end_zone || !same_inputs(before, i, now, j))
      changes.stale.push_back(static_cast<Index>(j));
    if (known) ++i;
  }
  changes.left.insert(changes.left.end(), old.begin() + static_cast<std::ptrdiff_t>(i), old.end());
  return changes;
}

std::vector<Index> nodes_from(const Chart& chart, double end_zone) {
  std::vector<Index> nodes;
  for (std::size_t i = 0; i < chart.size(); ++i)
    if (chart.t[i] >= end_zone) nodes.push_back(static_cast<Index>(i));
  return nodes;
}

}  // namespace burin
