#pragma once
#include <burin/base/rising_threshold.h>
#include <burin/chart/chart_options.h>
#include <burin/chart/live_chart.h>
#include <burin/chart/path/stroke_samples.h>
#include <burin/chart/transfer/cluster_contest.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/base_surface/base_surface.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace burin {

/// By how many spacings of the base nodes the base chart must be wider than the stroke, so that the clusters
/// of all vertices at the rim have nodes.
inline constexpr double transfer_margin = 1.5;

struct TransferredStroke {
  double radius;       ///< half width of the stroke at width 1, object units
  double base_radius;  ///< half width of the chart on the base surface, object units
  Cap cap;
};

/// Interpolates a growing chart of a base surface to the vertices of the surface. A vertex gets the
/// coordinates of its foot point on the base surface, by one second-order step from the node of its cluster
/// (CoordinatePatch). An event recomputes only the clusters of changed nodes and those that the stroke's end
/// influences. Uses all threads; the result does not depend on their number.
class ChartTransfer {
 public:
  /// Base and surface must outlive the object. The slots of the vertices' chart below `first_slot` are not
  /// used; the first update() removes their nodes.
  ChartTransfer(BaseSurface& base, const Surface& surface, const TransferredStroke& stroke, Index first_slot)
      : base_(&base),
        surface_(&surface),
        stroke_(stroke),
        first_slot_(first_slot),
        vertex_(first_slot),
        foot_(first_slot),
        contest_(base),
        near_end_(StrokeSamples::most_spacing(stroke.radius)) {}

  /// Applies the last event of the base chart `nodes`, which is the chart of this curve, to `vertices`.
  /// `curve` lies on the base surface. `on_base` is the stroke of the base chart's front.
  void update(const LiveChart& nodes, const FrontStroke& on_base, const SurfaceCurve& curve,
              LiveChart& vertices);

 private:
  /// The slots of the vertices' chart that belong to one slot of the base chart.
  struct Range {
    Index node = no_index;      ///< the base node, whose cluster it is
    Index begin = 0, room = 0;  ///< first slot, and number of slots reserved
    Index size = 0;             ///< number of slots in use; 0 until the cluster's feet were computed
    double last_t = nowhere;    ///< upper bound of the t that decided on its vertices in the last update
  };

  /// The results for a block of clusters, merged in order after the parallel loop.
  struct Transferred {
    struct Node {
      Index slot;
      ChartFrame frame;
      Vec3f normal;
    };
    LiveChart::Rewritten rewritten;
    std::vector<Index> gone;  ///< slots of vertices that left the stroke
    std::vector<Node> others;
    std::vector<Index> rivals;  ///< scratch
  };
  static constexpr double nowhere = -std::numeric_limits<double>::infinity();

  double unchanged_up_to(const LiveChart& nodes) const;
  void find_stale(const LiveChart& nodes, std::span<const Index> affected, double from);
  void make_room(const LiveChart& nodes, LiveChart& vertices);
  void find_feet(const BasePatch& patch, Range& range);
  /// The arguments of update().
  struct Event {
    const LiveChart& nodes;
    const FrontStroke& on_base;
    const SurfaceCurve& curve;
    LiveChart& vertices;
  };
  void transfer(const Event& event, Index slot, Transferred& transferred);
  void transfer_contested(const Event& event, Index slot, const BasePatch& patch, Transferred& transferred);
  void write(const Event& event, Index at, const ChartFrame& frame, const BasePatch& patch,
             Transferred& transferred);
  bool within(const ChartFrame& frame, const SurfaceCurve& curve) const;
  void vacate(Index slot, LiveChart& vertices);

  BaseSurface* base_;
  const Surface* surface_;
  TransferredStroke stroke_;
  Index first_slot_;
  bool uniform_ = true;        ///< the stroke's width is 1 everywhere
  double length_ = 0;          ///< length of the stroke at the last event
  std::vector<Range> ranges_;  ///< [slot of the base chart]
  std::vector<Index> vertex_;  ///< [slot of the vertices' chart] its vertex, inside the stroke or not
  std::vector<BasePatch::Local<float>> foot_;  ///< [slot of the vertices' chart] foot on its node's patch
  std::vector<Index> stale_;                   ///< slots of the base chart to recompute
  std::vector<std::uint8_t> is_stale_;         ///< [slot of the base chart] all 0 between events
  std::vector<Index> transferred_;             ///< slots of the base chart recomputed by the last event
  ClusterContest contest_;
  RisingThreshold near_end_;  ///< slots of the base chart by last_t
};

}  // namespace burin
