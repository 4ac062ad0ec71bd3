#include <burin/host/c/shown_values.h>

#include <cstring>
#include <limits>

namespace burin::c {

Ranges ShownValues::update(const VertexValues& current, const VertexOrder& order, std::uint64_t gap) {
  Ranges ranges(gap);
  changed_.drain(drained_);
  if (!seen_) {
    take_all(current, order);
    const std::size_t count = values_.size() / current.size;
    for (std::size_t number = 0; number < count; ++number) ranges.add(number);
    return ranges;
  }
  const std::size_t bytes = current.size * sizeof(float);
  for (const Index number : drained_) {
    float* const seen = values_.data() + number * current.size;
    float now[most_floats];
    current.copy(order.to_surface(number), now);
    if (std::memcmp(seen, now, bytes) == 0) continue;
    std::memcpy(seen, now, bytes);
    ranges.add(number);
  }
  return ranges;
}

void ShownValues::resize(Index vertex_count, Index kept) {
  values_.resize(kept * size_);
  // Values are never that.
  values_.resize(vertex_count * size_, std::numeric_limits<float>::quiet_NaN());
  changed_ = IndexSet(vertex_count);
  for (Index number = 0; number < vertex_count; ++number) changed_.insert(number);
}

void ShownValues::take_all(const VertexValues& current, const VertexOrder& order) {
  const auto count = static_cast<Index>(values_.size() / current.size);
  for (Index number = 0; number < count; ++number)
    current.copy(order.to_surface(number), values_.data() + number * current.size);
  seen_ = true;
}

}  // namespace burin::c
