#pragma once
#include <burin/chart/live_chart.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// The positions of the vertices under a stroke after one of its passes.
class PassPositions {
 public:
  /// `charts` are those of the stroke's instances. Surface and charts must outlive the object.
  PassPositions(const Surface& surface, std::vector<const LiveChart*> charts)
      : surface_(&surface), charts_(std::move(charts)), positions_(charts_.size()) {}

  Vec3f operator[](Index vertex) const {
    for (std::size_t i = 0; i < charts_.size(); ++i) {
      const Index local = charts_[i]->local_index(vertex);
      if (local != no_index && local < positions_[i].size()) return positions_[i][local];
    }
    return surface_->positions[vertex];
  }

  /// Sets the position of a vertex, which must be or have been in one of the charts.
  void set(Index vertex, const Vec3f& position);

 private:
  const Surface* surface_;
  std::vector<const LiveChart*> charts_;
  std::vector<std::vector<Vec3f>> positions_;  ///< [instance][local index in its chart]
};

}  // namespace burin
