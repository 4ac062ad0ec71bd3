#pragma once
#include <burin/chart/front/front.h>
#include <burin/chart/joins/leg_node.h>
#include <burin/chart/joins/stroke_legs.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// The charts of the legs of a stroke and of the bends between them. Each leg is charted as a stroke of its
/// own, which continues straight beyond its ends where a join needs that; bends have round ends. So every
/// vertex within the half width of the stroke has a node.
class LegCharts {
 public:
  /// The ground's surface must outlive the object.
  explicit LegCharts(const ChartGround& ground) : ground_(ground) {}

  /// Discards all charts. `radius`: half width at width 1, object units; `order`: 1 or 2.
  void begin(double radius, int order);

  /// Charts the legs of this curve. `front` does the work and must not be used for anything else between
  /// begin() and the last call. The curve is as in the last call up to the arc length `unchanged_t`; only
  /// legs that changed since are charted.
  void update(const SurfaceCurve& curve, double unchanged_t, const StrokeLegs& legs, Front& front);

  /// All nodes, in the order of (vertex, leg, t). On a closed stroke t is not reduced to [0, length).
  /// Distances and half widths are not set.
  std::vector<LegNode> nodes() const;

  /// The numbers of nodes settled and of queue entries pushed in the last update().
  std::uint64_t settled() const { return settled_; }
  std::uint64_t pushes() const { return pushes_; }

 private:
  struct Charted {
    Leg leg;
    std::vector<LegNode> nodes;

    /// Whether this chart is still that of the leg `now`, on a curve unchanged up to this arc length.
    bool is(const Leg& now, double unchanged_t) const { return leg == now && now.end < unchanged_t; }
  };
  void chart_leg(const SurfaceCurve& part, const Leg& now, bool closed, Front& front, Charted& charted);
  void chart_bend(const SurfaceCurve& part, const Leg& now, Charted& charted);
  void chart_with(Front& front, const SurfaceCurve& part, const Leg& now, Charted& charted);

  ChartGround ground_;
  double radius_ = 0;
  int order_ = 2;
  std::vector<Charted> legs_, bends_;
  std::optional<Front> bend_front_;  ///< charts bends; created for the first bend
  std::optional<Leg> front_leg_;     ///< the leg whose chart the caller's front holds
  std::uint64_t settled_ = 0, pushes_ = 0;
};

}  // namespace burin
