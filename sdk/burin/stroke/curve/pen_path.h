#pragma once
#include <burin/stroke/curve/curve_ground.h>
#include <burin/stroke/pen.h>

#include <cstddef>
#include <vector>

namespace burin {

/// A sample that the curve of a stroke passes through.
struct PenKnot {
  CurveGround::Point ground_point;
  double time = 0;  ///< seconds since the first sample
  Pen pen;
  double path_length = 0;  ///< length of the polyline of knots from the first knot to this one, object units
  std::size_t point = 0;   ///< index of the curve's point at this knot
  const Vec3f& position() const { return ground_point.at.position; }
};

/// Chooses the samples that become knots of the curve: all samples of a moving pen, none of a pen that rests
/// and trembles.
///
/// The pen comes to rest where it reverses its direction, or where it moved a tenth of the radius and is less
/// than half of that from where it was before. It moves again once it is a twentieth of the radius away from
/// where it rested. If it went straight away from there, as after a corner or when it retraces its path, all
/// samples since then become knots, else only the last one. Until then these samples are preliminary knots,
/// which a later sample may remove. A sample nearer to the one before than the least step becomes a knot only
/// when the pen is farther away, so that a slow pen makes no more knots than a fast one. The result depends
/// on the samples so far only.
class PenPath {
 public:
  /// `radius`: radius of the stroke; `least_step`: least distance between knots; object units.
  PenPath(double radius, double least_step);

  /// What a sample changed.
  enum class Change {
    none,
    pen,   ///< time or pen of the last knot
    path,  ///< the position of the last knot, or other knots
  };

  /// Adds a sample to the knots, which no other code may add to or remove. A sample that does not become a
  /// knot passes its pen to the last knot; a sample at the position of the last knot also passes its time.
  Change add(std::vector<PenKnot>& knots, const PenKnot& sample);

  /// The number of final knots; those after them are preliminary.
  std::size_t taken() const { return taken_; }

 private:
  void wait(const PenKnot& anchor, const PenKnot& sample);
  void go_on(std::vector<PenKnot>& knots);
  void rest(std::vector<PenKnot>& knots);
  void take_waiting(std::vector<PenKnot>& knots);
  void show(std::vector<PenKnot>& knots) const;
  bool turns_back(const std::vector<PenKnot>& knots) const;
  bool makes_no_progress(const std::vector<PenKnot>& knots) const;

  double least_step_, zone_;
  std::size_t taken_ = 0;
  std::vector<PenKnot> waiting_;  ///< samples since the last final knot; while the pen trembles only the last
  bool resting_ = false;
  bool trembles_ = false;  ///< the pen is at rest and went to and fro
  double farthest_ = 0;    ///< greatest distance from where the pen rests, object units
};

}  // namespace burin
