#pragma once
#include <burin/stroke/curve/surface_curve.h>

#include <functional>
#include <vector>

namespace burin {

/// How far the points near a stroke are from its ends along it, nearly without steps. The arc length t of the
/// nearest point of the stroke has great ones on the inside of a sharp bend, where the nearest point changes
/// to another part of the bend. Any thread.
class EndDistances {
 public:
  /// Where a position of a curve is in an image of it, of the same size.
  using Image = std::function<Vec3f(const Vec3f&)>;

  /// `curve`: at least one point; `radius`: of the stroke, object units; `most`: the greatest distance that
  /// is told apart, >= 0; `image`: of the curve that is meant, or empty. Copies what lies near the ends, in
  /// O(points that are copied).
  EndDistances(const SurfaceCurve& curve, double radius, double most, const Image& image = {});

  /// Of a dab, which has no ends.
  explicit EndDistances(double most);

  /// The distance for the coordinates (t, d) of the stroke's chart with the unit directions e1 and normal
  /// there, object units: at most `most`, at least the smaller one of `most` and the distance of t from the
  /// nearer end, and 0 at the least, apart from the middle of strokes shorter than twice `most`, where it is
  /// up to an eighth of the radius less so that it has no corner. A stroke without ends has the finite value
  /// nearest to `most` everywhere.
  float at(double t, double d, const Vec3f& e1, const Vec3f& normal) const;

  /// Whether the stroke bends more sharply than its radius near its begin.
  bool begin_bends() const { return begin_.bends; }

  /// How far along the stroke from t the curve is looked at, object units, for t within `most` of an end.
  static double reach(double radius, double most) { return most + 4 * radius; }

 private:
  /// One end of the stroke and what lies near it.
  struct End {
    std::vector<Vec3f> points;   ///< [i] the point that is i * spacing() away from the end along the stroke
    std::vector<float> x, y, z;  ///< of the points, and of some more that may be read but do not count
    std::vector<float> told;     ///< [i] the smaller one of `most` and along(i * spacing())
    bool bends = false;
  };
  double spacing() const;
  End end_of(std::vector<Vec3f> points) const;
  void split(End& end) const;
  double along(double s) const;
  float supremum(const End& end, double t, const Vec3f& from_foot) const;

  bool has_ends_ = false;
  double most_, length_ = 0, radius_ = 0;
  double rounding_ = 0;  ///< how far the ends' distances may differ in the middle of short strokes, where
                         ///< their minimum is rounded; 0 where the middle is farther than `most` from them
  End begin_, end_;
};

}  // namespace burin
