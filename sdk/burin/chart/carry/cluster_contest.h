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

/// Where the frame of a base node does not hold for all vertices of its cluster: parts of the stroke meet in
/// it, or lines of constant d turn within it. There each vertex goes with the node around it that places it
/// nearest to the stroke, and is held against the stroke itself.
class ClusterContest {
 public:
  /// The base must outlive the object.
  explicit ClusterContest(BaseSurface& base) : base_(&base) {}

  /// Follows the last event of the base chart. Returns slots whose vertices may go elsewhere than before,
  /// each once or more, vacant ones among them. Valid until the next call.
  std::span<const Index> update(const LiveChart& nodes);

  /// Whether there is any such node.
  bool any() const { return count_ > 0; }

  /// The slots that the vertices of this one's cluster choose from; none: its frame holds for all. Different
  /// slots on several threads at once.
  void find_rivals(const LiveChart& nodes, Index slot, std::vector<Index>& rivals);

  /// The frame of a place of the base surface from that of the slot's node on this stroke, along the straight
  /// way.
  ChartFrame told_by(const LiveChart& nodes, const StrokePath& path, Index slot,
                     const GroundPlace& place) const;

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
  std::vector<std::uint8_t> chosen_;     ///< [slot] its cluster had rivals when they were last asked for
  std::vector<std::uint8_t> was_near_;   ///< [slot] to the stroke, when it was last looked at
  std::vector<Index> node_of_;           ///< [slot] when it was last looked at
  std::size_t count_ = 0;                ///< of contested slots
  std::vector<Index> looked_at_;         ///< in the running update
  std::vector<std::uint8_t> is_looked_at_;
  std::vector<Index> affected_;
};

}  // namespace burin
