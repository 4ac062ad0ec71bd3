#pragma once
#include <burin/chart/bends.h>
#include <burin/chart/front.h>
#include <burin/chart/joins.h>
#include <burin/chart/stroke_chart.h>

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
/// together.
class JoinedLegs {
 public:
  /// The surface must outlive the object.
  explicit JoinedLegs(const Surface& surface) : surface_(&surface) {}

  /// Appends the nodes of the stroke (with round joins: in one piece), by means of the front, which starts
  /// afresh. The t of a closed stroke are not brought to [0, length).
  void place(const SurfaceCurve& curve, const ChartOptions& options, Front& front,
             std::vector<PlacedNode>& nodes);

 private:
  struct Leg {
    double begin, end;  ///< arc lengths on the stroke
  };
  void find_corners(const SurfaceCurve& curve);
  std::vector<Leg> legs_of(const SurfaceCurve& curve) const;
  void place_leg(const SurfaceCurve& curve, const std::vector<Leg>& legs, std::size_t leg, Front& front,
                 std::vector<PlacedNode>& nodes) const;
  void put_together(std::vector<PlacedNode>& nodes, bool closed) const;
  const Corner* corner_after(std::size_t leg, bool closed) const;
  const Corner* corner_before(std::size_t leg, bool closed) const;
  void smooth_long_bends(const SurfaceCurve& curve, std::vector<PlacedNode>& nodes) const;
  double span(const SurfaceCurve& curve, const Bend& bend) const;

  const Surface* surface_;
  ChartOptions options_;
  StrokeBends bends_;
  std::vector<Bend> cuts_;       ///< the bends that the stroke is cut at
  std::vector<Corner> corners_;  ///< [i] of cuts_[i]
};

}  // namespace burin
