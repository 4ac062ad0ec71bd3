// Collects the sheets of finished pieces by vertex, in O(nodes).
#include <burin/deform/blend/earlier_pieces.h>

namespace burin {

void EarlierPieces::add(std::span<const InstanceSheets> instances, double radius) {
  for (std::uint32_t image = 0; image < instances.size(); ++image) {
    const LiveChart& chart = *instances[image].chart;
    for (Index local = 0; local < chart.local_count(); ++local) {
      const Index vertex = chart.vertex_at(local);
      for (Index slot = chart.first(vertex); slot != no_index; slot = chart.next(slot))
        sheets_[vertex].push_back(instances[image].sheet(slot, radius, count_, image));
    }
  }
  ++count_;
}

std::span<const Sheet> EarlierPieces::at(Index vertex) const {
  const auto found = sheets_.find(vertex);
  return found == sheets_.end() ? std::span<const Sheet>{} : found->second;
}

}  // namespace burin
