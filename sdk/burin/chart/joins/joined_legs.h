#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/front/front.h>
#include <burin/chart/joins/bends.h>
#include <burin/chart/joins/joins.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A node of the chart of one leg.
struct LegNode {
  Index vertex;
  Index leg;  ///< index of the leg, in the order of t
  ChartFrame frame;
  double half_width;  ///< half width of the stroke at the node's t on its leg, object units
  double distance;    ///< from the leg, object units
};

inline bool beyond_end(double t, const SurfaceCurve& curve) {
  return !curve.closed && (t < 0 || t > curve.length());
}

/// Charts closed strokes and strokes with other than round joins. The stroke is cut at its bends, each leg is
/// charted as a stroke of its own that continues straight beyond its ends, and the legs' nodes are put
/// together. The bends at the cuts are charted as well, with round joins, so that every vertex within the
/// half width is covered. Joins choose between the nodes of a vertex; one without a chosen node takes that of
/// the bend, or else the nearest of its legs. So each vertex within the half width of any part has a node.
/// With `overlap`, a bend that is not a corner is a leg of its own.
class JoinedLegs {
 public:
  /// The ground's surface must outlive the object.
  explicit JoinedLegs(const ChartGround& ground) : ground_(ground) {}

  /// Discards all legs and starts a stroke with these options.
  void begin(const ChartOptions& options);

  /// Appends the nodes of the stroke; with round joins it is one leg. `front` does the work and must not be
  /// used for anything else between begin() and the last call. The curve is as in the last call up to the arc
  /// length `unchanged_t`; only legs that changed since are charted. On closed strokes t is not reduced to
  /// [0, length).
  void place(const SurfaceCurve& curve, double unchanged_t, Front& front, std::vector<LegNode>& nodes);

  /// The numbers of nodes settled and of queue entries pushed in the last call of place().
  std::uint64_t settled() const { return settled_; }
  std::uint64_t pushes() const { return pushes_; }

 private:
  struct Leg {
    double begin = 0, end = 0;  ///< arc lengths on the stroke
    Extensions reach;           ///< how far it continues beyond them, around smooth and mitered corners
    bool corner_before = false, corner_after = false;
    bool operator==(const Leg&) const = default;
  };
  struct ChartedLeg {
    Leg leg;
    std::vector<LegNode> nodes;

    /// Whether this chart is still that of the leg `now`, on a curve unchanged up to this arc length.
    bool is(const Leg& now, double unchanged_t) const { return leg == now && now.end < unchanged_t; }
  };
  bool is_corner(const Bend& bend) const;
  void find_corners(const SurfaceCurve& curve);
  double reach(const Corner* corner) const;
  std::vector<Leg> legs_of(const SurfaceCurve& curve) const;
  void chart(const SurfaceCurve& curve, std::size_t leg, const Leg& now, Front& front);
  void chart_bends(const SurfaceCurve& curve, double unchanged_t);
  ChartedLeg chart_with(Front& front, const SurfaceCurve& part, const Leg& now);
  void add_bends(const SurfaceCurve& curve, std::vector<LegNode>& nodes) const;
  void select_nodes(std::vector<LegNode>& nodes, bool closed) const;
  void keep_last(const SurfaceCurve& curve, std::vector<LegNode>& nodes) const;
  void smooth_corner(LegNode& node, const Corner& corner, bool first_leg) const;
  const Corner* corner_after(std::size_t leg, bool closed) const;
  const Corner* corner_before(std::size_t leg, bool closed) const;
  void smooth_long_bends(const SurfaceCurve& curve, std::vector<LegNode>& nodes) const;
  void smooth_bend(const SurfaceCurve& curve, const Bend& bend, std::span<LegNode> nodes) const;
  double span(const SurfaceCurve& curve, const Bend& bend) const;

  ChartGround ground_;
  ChartOptions options_;
  StrokeBends bends_;
  std::vector<Bend> cuts_;       ///< the bends at which the stroke is cut
  std::vector<Corner> corners_;  ///< [i] the corner at cuts_[i]
  std::vector<ChartedLeg> charted_;
  std::vector<ChartedLeg> charted_bends_;  ///< [i] the chart of cuts_[i]
  std::optional<Front> bend_front_;        ///< charts bends; created for the first bend
  std::uint64_t settled_ = 0, pushes_ = 0;
  std::optional<Leg> front_leg_;  ///< the leg whose chart the caller's front holds
};

}  // namespace burin
