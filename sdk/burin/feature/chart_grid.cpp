// Chooses the pixels of images over a chart.
#include <burin/feature/chart_grid.h>

#include <algorithm>
#include <cmath>

namespace burin {

ChartGrid chart_grid(double length, bool closed, double radius, double step, double margin) {
  const int steps = std::max(1, static_cast<int>(std::lround(length / step)));
  ChartGrid grid{.step_t = length / steps, .step_d = step, .closed = closed};
  const int wanted = static_cast<int>(std::ceil(margin / grid.step_t));
  grid.margin = closed ? std::min(wanted, steps) : wanted;
  // An open stroke has a column at either end, a closed one has one where they meet.
  grid.columns = steps + (closed ? 0 : 1) + 2 * grid.margin;
  grid.rows = 2 * static_cast<int>(std::ceil(radius / step)) + 1;
  return grid;
}

}  // namespace burin
