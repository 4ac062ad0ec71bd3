#pragma once
#include <burin/stroke/curve/curve_ground.h>
#include <burin/stroke/pen.h>

#include <cstddef>
#include <vector>

namespace burin {

/// A sample that a stroke's curve goes through.
struct PenKnot {
  CurveGround::Place place;
  double time = 0;  ///< since the first sample, seconds
  Pen pen;
  double way = 0;         ///< from the first knot, along straight lines from knot to knot, object units
  std::size_t point = 0;  ///< of the curve, where it goes through the knot
  const Vec3f& position() const { return place.at.position; }
};

/// Decides which samples lead a stroke on: all of a pen that moves, none of one that rests and trembles.
///
/// The pen comes to rest where it turns back, or where it went a tenth of the radius and is not half as far
/// from where that way began. It goes on once it is a twentieth of the radius from where it rested. If until
/// then it kept going away, as from a corner or back over its own way, all samples count, else only the last.
/// Until it goes on its samples may be shown, but be taken back. Samples nearer to the one before than the
/// least step count only once the pen is farther, so that a slow pen leaves no more of them than a fast one.
/// All depends on the samples so far alone.
class PenWay {
 public:
  /// `radius`: of the stroke, `least_step`: between samples, object units.
  PenWay(double radius, double least_step);

  enum class Change {
    none,
    pen,  ///< time or pen of the last knot
    way,  ///< its place, or other knots
  };

  /// Takes the next sample to the knots, which nobody else may add to or remove. Samples that do not count
  /// give their pen to the last knot; one in the very place of the last knot gives its time, too.
  Change add(std::vector<PenKnot>& knots, const PenKnot& sample);

  /// Knots that stay.
  std::size_t taken() const { return taken_; }

 private:
  void wait(const PenKnot& anchor, const PenKnot& sample);
  void go_on(std::vector<PenKnot>& knots);
  void rest(std::vector<PenKnot>& knots);
  void take_waiting(std::vector<PenKnot>& knots);
  void show(std::vector<PenKnot>& knots) const;
  bool turns_back(const std::vector<PenKnot>& knots) const;
  bool gets_nowhere(const std::vector<PenKnot>& knots) const;

  double least_step_, zone_;
  std::size_t taken_ = 0;
  std::vector<PenKnot> waiting_;  ///< samples since the last knot that stays; of a tremble only the last
  bool resting_ = false;
  bool trembles_ = false;  ///< at rest, and went to and fro
  double farthest_ = 0;    ///< from where it rests
};

}  // namespace burin
