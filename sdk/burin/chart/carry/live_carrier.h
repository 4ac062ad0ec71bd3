#pragma once
#include <burin/base/rising_threshold.h>
#include <burin/chart/carry/cluster_contest.h>
#include <burin/chart/chart_options.h>
#include <burin/chart/live_chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/base_surface/base_surface.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace burin {

/// How far, in spacings, the chart of a base surface must reach beyond the stroke, for the clusters of all
/// vertices at its rim to have nodes.
inline constexpr double carrying_margin = 1.5;

struct CarriedStroke {
  double radius;       ///< half width of the stroke at width 1, object units
  double base_radius;  ///< the same of its chart on the base surface
  Cap cap;
};

/// Carries a growing chart of a base surface over to the vertices of the surface: each has the coordinates of
/// its foot on the base surface, one step of second order from the node of its cluster (CoordinatePatch).
/// Only what belongs to nodes that changed is carried again, and what the stroke's end decides on. On all
/// threads.
class LiveCarrier {
 public:
  /// Base and surface must outlive the object.
  LiveCarrier(BaseSurface& base, const Surface& surface, const CarriedStroke& stroke)
      : base_(&base), surface_(&surface), stroke_(stroke), contest_(base), near_end_(stroke.radius / 8) {}

  /// The curve as the base chart needs it: as much wider everywhere as the margin is. Valid until the next
  /// call.
  const SurfaceCurve& widened(const SurfaceCurve& curve);

  /// Follows the last event of the base chart, of this curve, which is on the base surface. `on_base`: what
  /// the chart's front knows of the stroke; null: the chart was put together from several.
  void update(const LiveChart& nodes, const FrontStroke* on_base, const SurfaceCurve& curve,
              LiveChart& vertices);

 private:
  /// The vertices' slots that the cluster of a slot of the base chart has.
  struct Range {
    Index node = no_index;      ///< the cluster
    Index begin = 0, room = 0;  ///< slots of vertices
    Index size = 0;             ///< of them, as many as the cluster has; 0 until it has been carried
    double last_t = nowhere;    ///< the highest of the vertices' when they were last carried
  };

  /// What a few clusters' vertices became.
  struct Carried {
    struct Node {
      Index slot;
      ChartFrame frame;
      Vec3f normal;
    };
    LiveChart::Rewritten rewritten;
    std::vector<Index> gone;  ///< slots of vertices outside the stroke
    std::vector<Node> others;
    std::vector<Index> rivals;  ///< scratch
  };
  static constexpr double nowhere = -std::numeric_limits<double>::infinity();

  double unchanged_up_to(const LiveChart& nodes) const;
  void find_stale(const LiveChart& nodes, std::span<const Index> affected, double from);
  void make_room(const LiveChart& nodes, LiveChart& vertices);
  void find_feet(const BasePatch& patch, Range& range);
  /// An event: the base chart, what its front knows of the stroke or null, the stroke, and the result.
  struct Event {
    const LiveChart& nodes;
    const FrontStroke* on_base;
    const SurfaceCurve& curve;
    LiveChart& vertices;
  };
  void carry(const Event& event, Index slot, Carried& carried);
  void carry_contested(const Event& event, Index slot, const BasePatch& patch, Carried& carried);
  void place(const Event& event, Index at, const ChartFrame& frame, const BasePatch& patch, Carried& carried);
  bool within(const ChartFrame& frame, const SurfaceCurve& curve) const;
  void vacate(Index slot, LiveChart& vertices);

  BaseSurface* base_;
  const Surface* surface_;
  CarriedStroke stroke_;
  SurfaceCurve widened_;
  bool uniform_ = true;        ///< the stroke's width is 1 all along
  double length_ = 0;          ///< of the stroke, at the last event
  std::vector<Range> ranges_;  ///< [slot of the base chart]
  std::vector<Index> vertex_;  ///< [slot of the vertices' chart] of the clusters, in the stroke or not
  std::vector<BasePatch::Local<float>> foot_;  ///< [the same] on the patch of its cluster's node
  std::vector<Index> stale_;                   ///< slots of the base chart to be carried
  std::vector<std::uint8_t> is_stale_;         ///< [slot of the base chart] all 0 between events
  std::vector<Index> carried_;                 ///< those of the last event
  ClusterContest contest_;
  RisingThreshold near_end_;  ///< slots of the base chart by last_t
};

}  // namespace burin
