// Takes a path from the image of a chart back to the surface. Costs O(n) for n nodes, with n log n for those
// near the path only.
#include <burin/feature/path_on_surface.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Triangles reach at most so many typical edges from the path that goes through them.
constexpr double edges_around = 2.5;

/// The cubic from b to c, at a share s, that has the slopes of the parabolas through three values.
double catmull_rom(double a, double b, double c, double d, double s) {
  const double from = (c - a) / 2, to = (d - b) / 2, rise = c - b;
  return b + s * (from + s * (3 * rise - 2 * from - to + s * (from + to - 2 * rise)));
}

/// The nodes within `reach` (object units) of a path. Looking it up in them takes a fraction of the time that
/// it would take in the whole chart.
Chart part_near(const Chart& chart, const FinePath& path, const ChartGrid& grid, double reach) {
  const double last = static_cast<double>(path.points.size() - 1);
  std::vector<std::size_t> nodes;
  for (std::size_t node = 0; node < chart.size(); ++node) {
    const double at = std::clamp(std::round(chart.t[node] / path.step), 0., last);
    const double d = grid.d(path.points[static_cast<std::size_t>(at)].row);
    if (std::abs(static_cast<double>(chart.d[node]) - d) <= reach) nodes.push_back(node);
  }
  Chart part;
  part.length = chart.length;
  part.closed = chart.closed;
  part.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    part.set(i, chart.vertex[nodes[i]], chart.sheet[nodes[i]], chart.frame(nodes[i]), chart.normal[nodes[i]]);
  return part;
}

}  // namespace

FinePath finer_path(const std::vector<PathColumn>& columns, const ChartGrid& grid, double spacing) {
  const int parts = spacing > 0 ? std::max(1, static_cast<int>(std::ceil(grid.step_t / spacing))) : 1;
  const auto count = static_cast<std::ptrdiff_t>(columns.size());
  const auto column = [&](std::ptrdiff_t i) -> const PathColumn& {
    const std::ptrdiff_t at = grid.closed ? (i + count) % count : std::clamp<std::ptrdiff_t>(i, 0, count - 1);
    return columns[static_cast<std::size_t>(at)];
  };
  FinePath path{{}, grid.step_t / parts};
  for (std::ptrdiff_t i = 0; i < (grid.closed ? count : count - 1); ++i) {
    for (int part = 0; part < parts; ++part) {
      const double row = catmull_rom(column(i - 1).row, column(i).row, column(i + 1).row, column(i + 2).row,
                                     static_cast<double>(part) / parts);
      path.points.push_back({row, column(2 * part < parts ? i : i + 1).significance});
    }
  }
  if (!grid.closed) path.points.push_back(columns.back());
  return path;
}

PathLookup::PathLookup(const Surface& surface, const Chart& chart, const SampledFeature& sampled,
                       const FinePath& path, double edge)
    : sampled_(sampled),
      part_(part_near(chart, path, sampled.level().grid, edges_around * edge)),
      lookup_(surface, part_) {}

std::optional<SurfacePoint> PathLookup::at(double t, double row) const {
  const ChartGrid& grid = sampled_.level().grid;
  if (auto point = sampled_.point_at(grid.x(t), row)) return point;
  const auto found = lookup_.find(t, grid.d(row));
  return found ? std::optional(found->at) : std::nullopt;
}

}  // namespace burin
