#pragma once
#include <burin/chart/live_chart.h>
#include <burin/chart/stroke_chart.h>
#include <burin/stroke/surface_curve.h>
#include <burin/surface/base_surface.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// How far, in spacings, the chart of a base surface must reach beyond the stroke, for the vertices at its
/// rim to have nodes around them.
inline constexpr double carrying_margin = 2.5;

struct CarriedStroke {
  double radius;       ///< half width of the stroke at width 1, object units
  double base_radius;  ///< the same of its chart on the base surface
  Cap cap;
};

/// Carries a growing chart of a base surface over to the vertices of the surface: each has the coordinates of
/// its foot on the base surface, one step of second order from the node of its cluster (CoordinatePatch).
/// Only what belongs to nodes that were computed is carried again. On all threads.
class LiveCarrier {
 public:
  /// Base and surface must outlive the object.
  LiveCarrier(const BaseSurface& base, const Surface& surface, const CarriedStroke& stroke)
      : base_(&base), surface_(&surface), stroke_(stroke) {}

  /// The curve as the base chart needs it: as much wider everywhere as the margin is. Valid until the next
  /// call.
  const SurfaceCurve& widened(const SurfaceCurve& curve);

  /// Follows the last event of the base chart, of this curve, which is on the base surface.
  void update(const LiveChart& nodes, const SurfaceCurve& curve, LiveChart& vertices);

 private:
  /// Vertices of one node that lie within the stroke.
  struct Carried {
    Index place;  ///< of the vertex among those of its cluster
    Index vertex;
    ChartFrame frame;
    Vec3f normal;
  };
  void carry(const LiveChart& nodes, Index slot, const SurfaceCurve& curve, std::vector<Carried>& out) const;
  bool within(const ChartFrame& frame, const SurfaceCurve& curve) const;
  void place(Index slot, Index cluster_size, std::span<const Carried> carried, LiveChart& vertices);
  void vacate(Index slot, LiveChart& vertices);

  const BaseSurface* base_;
  const Surface* surface_;
  CarriedStroke stroke_;
  SurfaceCurve widened_;
  bool uniform_ = true;  ///< the stroke's width is 1 all along
  /// [slot of the base chart] where its cluster's slots begin, and how many there are.
  struct Range {
    Index begin = 0, size = 0;
  };
  std::vector<Range> ranges_;
  Index slots_ = 0;  ///< of the vertices' chart, so far
};

}  // namespace burin
