// Measures evaluate by the least time of several runs, which other processes disturb least.
#include "validate/checks/timing.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "system/platform.h"

namespace burin::validate {
namespace {

/// The least time of some runs, nanoseconds of this thread: on a busy machine a long run never has a
/// processor for itself.
double least_time(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < runs; ++i) {
    const double start = thread_seconds();
    work();
    least = std::min(least, 1e9 * (thread_seconds() - start));
  }
  return least;
}

}  // namespace

double evaluate_time(const ProbeStroke& stroke, const Nodes& nodes, int runs) {
  std::vector<Row> rows(nodes.size());
  const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
  const burin_outputs outputs = outputs_of(rows);
  return least_time(runs, [&] { stroke.call(batch, outputs); }) / static_cast<double>(nodes.size());
}

double copy_time(const burin_brush_descriptor& brush, const Nodes& nodes, int runs) {
  std::vector<const std::vector<float>*> declared;
  std::size_t column = 0;
  for (const InputColumns& input : input_columns())
    for (std::size_t k = 0; k < input.count; ++k, ++column)
      if (brush.inputs_read & input.bit) declared.push_back(&nodes.columns[column]);
  // A brush without inputs is compared with a copy of one column.
  if (declared.empty()) declared.push_back(&nodes.columns.front());
  std::vector<float> copy(nodes.size());
  volatile float sink = 0;
  return least_time(runs,
                    [&] {
                      for (const auto* from : declared) {
                        std::copy(from->begin(), from->end(), copy.begin());
                        sink = copy[copy.size() / 2];
                      }
                    }) /
         static_cast<double>(nodes.size());
}

}  // namespace burin::validate
