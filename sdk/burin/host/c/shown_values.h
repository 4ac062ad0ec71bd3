#pragma once
#include <burin/base/index_set.h>
#include <burin/host/c/ranges.h>
#include <burin/host/c/vertex_order.h>
#include <burin/host/c/vertex_values.h>

#include <span>
#include <vector>

namespace burin::c {

/// The values of one attribute as the caller last saw them, by the caller's numbers, and the vertices that
/// may have changed since.
class ShownValues {
 public:
  /// All vertices count as changed.
  ShownValues(Index vertex_count, std::size_t size)
      : size_(size), values_(vertex_count * size), changed_(vertex_count) {}

  const float* data() const { return values_.data(); }

  /// Follows a surface that has other vertices than before, but for the first `kept`. All may have changed;
  /// new ones have.
  void resize(Index vertex_count, Index kept);

  /// Notes vertices of the surface that may have changed, in any order.
  void note(std::span<const Index> vertices, const VertexOrder& order) {
    for (const Index vertex : vertices) changed_.insert(order.of_surface(vertex));
  }

  /// Takes the current values. Returns the ranges of vertices where a bit differs, or of all vertices the
  /// first time. O(noted vertices).
  Ranges update(const VertexValues& current, const VertexOrder& order, std::uint64_t gap);

 private:
  void take_all(const VertexValues& current, const VertexOrder& order);

  std::size_t size_;  ///< floats of a vertex
  std::vector<float> values_;
  IndexSet changed_;
  std::vector<Index> drained_;
  bool seen_ = false;
};

}  // namespace burin::c
