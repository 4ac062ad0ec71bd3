// Steps between the numbers of vertices that a surface has and those of the mesh that it was made of, in
// O(k log k) for k vertices.
#include <burin/base/error.h>
#include <burin/host/session/released_step.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace burin {
namespace {

void to_source(std::vector<Index>& vertices, std::span<const Index> source) {
  for (Index& vertex : vertices) vertex = source[vertex];
}

/// The numbers on the surface of vertices of the original mesh.
std::vector<Index> to_surface(const std::vector<Index>& vertices, std::span<const Index> of_source) {
  std::vector<Index> numbers;
  numbers.reserve(vertices.size());
  for (const Index vertex : vertices) {
    if (vertex >= of_source.size()) throw Error("the step is of a mesh with more vertices");
    numbers.push_back(of_source[vertex]);
  }
  return numbers;
}

template <class Value>
std::vector<Value> in_order(const std::vector<Value>& values, const std::vector<std::size_t>& order) {
  std::vector<Value> ordered;
  if (values.empty()) return ordered;
  ordered.reserve(order.size());
  for (const std::size_t i : order) ordered.push_back(values[i]);
  return ordered;
}

/// The order in which numbers ascend.
std::vector<std::size_t> ascending(const std::vector<Index>& numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return numbers[i]; });
  return order;
}

}  // namespace

void release_values(UndoStep step, std::span<const Index> source, StrokeStep& into) {
  into.vertices = std::move(step.vertices);
  into.positions = std::move(step.positions);
  into.painted_vertices = std::move(step.paint.vertices);
  into.colours = std::move(step.paint.colours);
  into.masks = std::move(step.paint.masks);
  to_source(into.vertices, source);
  to_source(into.painted_vertices, source);
}

UndoStep values_for(const StrokeStep& step, std::span<const Index> of_source) {
  const std::vector<Index> vertices = to_surface(step.vertices, of_source);
  const std::vector<Index> painted = to_surface(step.painted_vertices, of_source);
  const std::vector<std::size_t> order = ascending(vertices), paint_order = ascending(painted);
  UndoStep made;
  made.vertices = in_order(vertices, order);
  made.positions = in_order(step.positions, order);
  made.paint.vertices = in_order(painted, paint_order);
  made.paint.colours = in_order(step.colours, paint_order);
  made.paint.masks = in_order(step.masks, paint_order);
  return made;
}

}  // namespace burin
