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

/// A node of a stroke's chart.
struct PlacedNode {
  Index vertex;
  Index leg;  ///< of the stroke, by rising t
  ChartFrame frame;
  double half_width;  ///< of the stroke at the node's t on its leg
};

inline bool beyond_end(double t, const SurfaceCurve& curve) {
  return !curve.closed && (t < 0 || t > curve.length());
}

/// Charts of strokes whose bends are joined in other ways than the distances have it: the stroke is cut at
/// its bends, each leg is charted as a stroke of its own that goes on straight, and the legs' nodes are put
/// together. The bends that it is cut at are charted too, with round joins, so that what is charted is all of
/// the stroke: each vertex within its half width is in reach of the part that is nearest. Vertices that the
/// legs leave have the node of the bend (but around smooth corners that are no half turns); with `overlap` a
/// bend that is no corner is a leg of its own.
class JoinedLegs {
 public:
  explicit JoinedLegs(const ChartGround& ground) : ground_(ground) {}

  /// Forgets the legs of the stroke before.
  void begin(const ChartOptions& options);

  /// Appends the nodes of the stroke (with round joins: in one piece), by means of the front, which serves
  /// nobody else meanwhile. Only legs that differ from those of the last call are charted; the curve is as it
  /// was then up to its arc length `unchanged_t`. The t of a closed stroke are not brought to [0, length).
  void place(const SurfaceCurve& curve, double unchanged_t, Front& front, std::vector<PlacedNode>& nodes);

  /// Nodes settled and queue entries pushed in the last call of place().
  std::uint64_t settled() const { return settled_; }
  std::uint64_t pushes() const { return pushes_; }

 private:
  struct Leg {
    double begin = 0, end = 0;  ///< arc lengths on the stroke
    Extensions reach;           ///< beyond them, to the outer ends of mitered corners
    bool corner_before = false, corner_after = false;
    bool operator==(const Leg&) const = default;
  };
  struct ChartedLeg {
    Leg leg;
    std::vector<PlacedNode> nodes;

    /// Whether it still is, where the curve has not changed up to this arc length.
    bool is(const Leg& now, double unchanged_t) const { return leg == now && now.end < unchanged_t; }
  };
  bool is_corner(const Bend& bend) const;
  bool is_filled(const Bend& corner) const;
  void find_corners(const SurfaceCurve& curve);
  double reach(const Corner* corner) const;
  std::vector<Leg> legs_of(const SurfaceCurve& curve) const;
  void chart(const SurfaceCurve& curve, std::size_t leg, const Leg& now, Front& front);
  void chart_bends(const SurfaceCurve& curve, double unchanged_t);
  ChartedLeg chart_with(Front& front, const SurfaceCurve& part, const Leg& now);
  void add_bends(const SurfaceCurve& curve, std::vector<PlacedNode>& nodes) const;
  void put_together(std::vector<PlacedNode>& nodes, bool closed) const;
  const Corner* corner_after(std::size_t leg, bool closed) const;
  const Corner* corner_before(std::size_t leg, bool closed) const;
  void smooth_long_bends(const SurfaceCurve& curve, std::vector<PlacedNode>& nodes) const;
  void smooth_bend(const SurfaceCurve& curve, const Bend& bend, std::span<PlacedNode> nodes) const;
  double span(const SurfaceCurve& curve, const Bend& bend) const;

  ChartGround ground_;
  ChartOptions options_;
  StrokeBends bends_;
  std::vector<Bend> cuts_;       ///< the bends that the stroke is cut at
  std::vector<Corner> corners_;  ///< [i] of cuts_[i]
  std::vector<ChartedLeg> charted_;
  std::vector<ChartedLeg> charted_bends_;  ///< [i] of cuts_[i]
  std::optional<Front> bend_front_;        ///< charts bends; there once there are any
  std::uint64_t settled_ = 0, pushes_ = 0;
  std::optional<Leg> front_leg_;  ///< whose chart the front has
};

}  // namespace burin
