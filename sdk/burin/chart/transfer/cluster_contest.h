#pragma once
#include <burin/chart/chart_ground.h>
#include <burin/chart/live_chart.h>
#include <burin/chart/path/front_stroke.h>
#include <burin/surface/base_surface/base_surface.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace burin {

/// Finds the nodes of a base surface's chart that are contested: their frame does not hold for all vertices
/// of their cluster, since parts of the stroke meet within it or lines of constant d turn sharply. There each
/// vertex takes its frame from the node around it, a rival, that places it nearest to the stroke, and the
/// frame is checked against the stroke itself (mended_frame.h).
class ClusterContest {
 public:
  /// The base must outlive the object.
  explicit ClusterContest(BaseSurface& base) : base_(&base) {}

  /// Follows the last event of the base chart. Returns slots whose vertices may choose other nodes than
  /// before. A slot may appear several times and may be vacant. The span is valid until the next call.
  std::span<const Index> update(const LiveChart& nodes);

  /// Whether any node is contested.
  bool any() const { return count_ > 0; }

  /// Lists the slots that the vertices of this slot's cluster choose from. The list is empty when the slot's
  /// own frame holds for all of them. Several threads may call this at once for different slots.
  void find_rivals(const LiveChart& nodes, Index slot, std::vector<Index>& rivals);

  /// The frame at a point of the base surface, extrapolated by one straight step from the slot's node.
  ChartFrame extrapolate(const LiveChart& nodes, const StrokePath& path, Index slot,
                         const GroundVertex& place) const;

 private:
  bool is_contested(const LiveChart& nodes, Index slot) const;
  bool is_of_visit(const LiveChart& nodes, Index slot, Index rival) const;
  bool is_near_stroke(const LiveChart& nodes, Index slot) const;
  void look_at(const LiveChart& nodes, Index slot);
  void leave(const LiveChart& nodes, Index slot);
  void look_around(const LiveChart& nodes, Index node, bool is_near_stroke);
  void follow(const LiveChart& nodes, Index slot);
  void affect_around(const LiveChart& nodes, Index node, bool all);
  template <class Visit>
  void for_each_around(const LiveChart& nodes, Index node, const Visit& visit) const;

  BaseSurface* base_;
  std::vector<std::uint8_t> contested_;  ///< [slot]
  std::vector<std::uint8_t> chosen_;     ///< [slot] its cluster had rivals at the last find_rivals()
  std::vector<std::uint8_t> was_near_;   ///< [slot] it was near the stroke when last examined
  std::vector<Index> node_of_;           ///< [slot] its base node when last examined
  std::size_t count_ = 0;                ///< number of contested slots
  std::vector<Index> looked_at_;         ///< slots to examine in the running update
  std::vector<std::uint8_t> is_looked_at_;
  std::vector<Index> affected_;
};

}  // namespace burin
