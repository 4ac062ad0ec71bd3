#pragma once
#include <burin/chart/front/front_part.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace burin {

/// The front that spreads a stroke's coordinates over its surroundings, and the coordinates themselves. They
/// are a function of the ground, the curve, the radius and the order: update() replaces the curve and
/// recomputes what follows from the difference, with the result of a fresh start bit for bit.
///
/// Nodes are visits of the stroke to vertices. A node leads on to the nodes of the neighbouring vertices
/// whose run holds the sample at its own t. Settled nodes within the stroke are inside and lead on.
///
/// A front may be cut into parts by vertices, which advance side by side, one step of distance at a time, and
/// tell each other between steps what happened at their borders.
class Front {
 public:
  /// Over which the stroke's curvature is estimated, on either side, in shares of the radius.
  static constexpr double curvature_window = 0.25;

  /// The ground must outlive the front, and keep its number of vertices.
  explicit Front(const ChartGround& ground);

  /// Forgets everything; the ground may have changed. `radius`: half width of the stroke at width 1, object
  /// units. `order`: 1 or 2.
  void restart(double radius, int order, const Extensions& extensions = {});

  /// Goes over to this curve, of at least one point. Its first `unchanged` points are known to be those of
  /// the curve before. After restart() the front has `parts`
  /// parts; one on a base surface.
  void update(const SurfaceCurve& curve, std::size_t unchanged = 0, std::size_t parts = 1);

  /// The nodes inside of each part, ascending by vertex and t, through all of them.
  std::vector<std::vector<const FrontNode*>> inside();

  /// Calls visit(slot, node) for the nodes that may have changed in the last update(). A node keeps its slot.
  template <class Visit>
  void for_each_touched(const Visit& visit) const {
    const auto count = static_cast<Index>(parts_.size());
    for (Index part = 0; part < count; ++part)
      for (const Index node : parts_[part]->touched())
        visit(node * count + part, parts_[part]->nodes()[node]);
  }

  /// Nodes of this t or more were computed by the last update().
  double unchanged_t() const { return unchanged_t_; }

  const FrontStroke& stroke() const { return stroke_; }

  /// Half width of the stroke at the arc length t, object units.
  double half_width(double t) const { return stroke_.samples.half_width(t); }

  /// Nodes settled and queue entries pushed in the last update().
  std::uint64_t settled() const;
  std::uint64_t pushes() const;

 private:
  void cut(const SurfaceCurve& curve, std::size_t parts);
  CurveChange replace_curve(const SurfaceCurve& curve, std::size_t unchanged);
  void advance_in_steps(const CurveChange& change);

  ChartGround ground_;
  FrontStroke stroke_;
  double unchanged_t_ = 0;
  std::vector<Index> blocks_;  ///< see ChartNodes
  std::vector<std::unique_ptr<FrontPart>> parts_;
};

}  // namespace burin
