// Sorts the nodes of a chart into the columns of an image by counting.
#include <burin/feature/chart_samples.h>

#include <array>
#include <cmath>

namespace burin {
namespace {

/// Sets area and mean normal of a vertex; those of points are alike.
void set_area(ChartSample& sample, const Surface& surface, Index vertex) {
  sample.area = 1;
  sample.mean_normal = sample.normal = surface.normals[vertex];
  if (surface.is_point_set()) return;
  Vec3f sum = Vec3f::Zero();
  float doubled = 0;
  for (const Index triangle : surface.incident[vertex]) {
    const auto& [a, b, c] = surface.triangles[triangle];
    const Vec3f& at = surface.positions[a];
    const Vec3f cross = (surface.positions[b] - at).cross(surface.positions[c] - at);
    sum += cross;
    doubled += cross.norm();
  }
  sample.area = doubled / 6;
  if (doubled > 0) sample.mean_normal = sum / doubled;
}

/// Calls visit(column) for the columns of a node at `x`, which has several on closed strokes.
template <class Visit>
void for_each_place(const ChartGrid& grid, double x, const Visit& visit) {
  const auto emit = [&](double at) {
    const double column = std::round(at);
    if (column >= 0 && column < grid.columns) visit(at, static_cast<std::size_t>(column));
  };
  emit(x);
  if (!grid.closed) return;
  emit(x - grid.inner_columns());
  emit(x + grid.inner_columns());
}

}  // namespace

ChartSamples::ChartSamples(const Surface& surface, const Chart& chart, const ChartGrid& grid) : grid_(grid) {
  if (chart.size() > 0) origin_ = surface.positions[chart.vertex[chart.size() / 2]];
  const auto columns = static_cast<std::size_t>(grid.columns);
  offsets_.assign(columns + 1, 0);
  for (std::size_t node = 0; node < chart.size(); ++node)
    for_each_place(grid, grid.x(chart.t[node]), [&](double, std::size_t column) { ++offsets_[column + 1]; });
  for (std::size_t column = 0; column < columns; ++column) offsets_[column + 1] += offsets_[column];
  samples_.resize(offsets_.back());
  std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t node = 0; node < chart.size(); ++node) {
    const Index vertex = chart.vertex[node];
    ChartSample sample{.y = static_cast<float>(grid.y(static_cast<double>(chart.d[node]))),
                       .vertex = vertex,
                       .position = surface.positions[vertex] - origin_,
                       .mean_normal = Vec3f::Zero(),
                       .normal = Vec3f::Zero()};
    set_area(sample, surface, vertex);
    for_each_place(grid, grid.x(chart.t[node]), [&](double x, std::size_t column) {
      sample.x = static_cast<float>(x);
      samples_[next[column]++] = sample;
    });
  }
}

}  // namespace burin
