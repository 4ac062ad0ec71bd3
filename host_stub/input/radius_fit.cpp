// Compares the radii of strokes with the edges and the size of a surface, in O(vertices).
#include "input/radius_fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "system/console.h"

namespace burin {

double mean_edge_length(const Surface& surface) {
  double sum = 0;
  std::size_t count = 0;
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    for (const Index neighbour : surface.neighbours[vertex]) {
      sum += static_cast<double>((surface.positions[vertex] - surface.positions[neighbour]).norm());
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

void warn_of_small_radii(const std::string& path, const Surface& surface, const std::vector<double>& radii) {
  if (radii.empty()) return;
  const double least = std::ranges::min(radii), edge = mean_edge_length(surface);
  if (least < edge / 2)
    warn(fmt::format(
        "{}: a radius of {:.3g} is small against the mean edge, {:.3g}: little of the stroke meets "
        "a vertex",
        path, least, edge));
}

void warn_of_great_radii(const std::string& path, const Surface& surface, const std::vector<double>& radii) {
  if (radii.empty()) return;
  const double greatest = std::ranges::max(radii);
  if (greatest > surface.scale)
    warn(
        fmt::format("{}: a radius of {:.3g} is greater than the whole surface, {:.3g}: strokes on it are too "
                    "short for it",
                    path, greatest, surface.scale));
}

}  // namespace burin
