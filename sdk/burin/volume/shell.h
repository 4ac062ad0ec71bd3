#pragma once
#include <burin/volume/solid.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace burin {

/// A triangle of a chart, thickened along the normals of its corners, which need not be parallel.
class Prism {
 public:
  struct Corner {
    Vec3d position, normal;  ///< of the base surface
    double t = 0;            ///< object units; counted beside each other on closed strokes
    float d = 0;
    Vec3d along_t, along_d;  ///< gradients of t and d there, in the tangent plane
    Vec3d e1;                ///< unit, along the stroke
  };

  /// `rim`: whether the edge opposite a corner has no other triangle of the chart beyond it. The prism goes
  /// on beyond such an edge, by about the triangle's own height.
  Prism(const std::array<Corner, 3>& corners, const std::array<Index, 3>& nodes,
        const std::array<bool, 3>& rim);

  /// Calls visit(point) with what the chart is where p lies over the triangle; t is not wrapped. Once, or not
  /// at all where p does not lie over it, or beyond a focal point. Where the stroke's coordinates differ
  /// between the corners, as along the line inside of a bend where both of its legs are as near, once for
  /// each corner, with what its own coordinates go on to.
  template <class Visit>
  void find(const Vec3d& p, const Visit& visit) const {
    const std::optional<Foot> foot = foot_of(p);
    if (!foot) return;
    if (!parted_) return visit(between(*foot));
    for (std::size_t corner = 0; corner < 3; ++corner) visit(from_corner(*foot, corner));
  }

  /// The axis along which the prism is longest: the layers across it are small.
  int axis() const { return axis_; }

  /// Holds all points of heights between these that find() finds.
  Eigen::AlignedBox3d box(double h_min, double h_max) const;

  /// The same of those whose coordinate along axis() is within these bounds. Empty where there are none.
  Eigen::AlignedBox3d layer(double h_min, double h_max, double low, double high) const;

  const std::array<Index, 3>& nodes() const { return nodes_; }

  /// The other way around: (t, d) where the corners 1 and 2 have the weights a and b, to second order, and
  /// the point of space at a height over there, object units. Beyond the triangle both go on.
  Vec2d coordinates(double a, double b) const { return coordinates_at(a, b, position(a, b, 0)); }
  Vec3d point(double a, double b, double height) const;

  Vec2d coordinates_of(std::size_t corner) const {
    return {corners_[corner].t, static_cast<double>(corners_[corner].d)};
  }

  /// Whether the coordinates at the corners are those of different legs of a bend.
  bool parted() const { return parted_; }

  /// Whether the triangle's own side is that of its normals: others hold no points.
  bool upright() const;

 private:
  struct Foot {
    double a, b, h;
    Vec3d position;
  };

  std::optional<Foot> foot_of(const Vec3d& p) const;
  ShellPoint between(const Foot& foot) const;
  Vec2d coordinates_at(double a, double b, const Vec3d& foot) const;
  ShellPoint from_corner(const Foot& foot, std::size_t corner) const;
  Vec3d position(double a, double b, double h) const;
  /// Of (a, b, h) at this height: the columns are the derivatives of position().
  Eigen::Matrix3d jacobian(double a, double b, double h) const;
  std::array<Vec3d, 3> edge_at(double h) const;
  bool is_parted() const;
  bool folded(double a, double b, double h) const;
  bool within(double a, double b) const;

  std::array<Corner, 3> corners_;
  std::array<Index, 3> nodes_;
  std::array<bool, 3> rim_;                      ///< of the edge opposite a corner
  Vec3d edge_a_, edge_b_, normal_a_, normal_b_;  ///< from corner 0 to 1 and 2
  Vec3d up_;                                     ///< unit normal of the triangle
  double size_;                                  ///< length of the longer of the two edges, object units
  std::array<double, 3> least_weight_;           ///< that within() allows
  int axis_;
  bool parted_ = false;
};

/// All prisms over a chart, in the order of its triangles.
std::vector<Prism> shell_over(const SolidGround& ground);

}  // namespace burin
