#pragma once
#include <burin/base/vector.h>

#include <array>
#include <span>
#include <vector>

namespace burin {

/// A place of a line, found for itself.
struct LinePlace {
  double t = 0;  ///< arc length along the curve that the line was searched from, object units
  Vec3d position;
  double smoothed_away = 0;  ///< distance of the smoothed line, object units
};

/// A line that goes on to a corner: a parabola.
struct Leg {
  std::array<Vec3d, 3> terms{};  ///< of 1, x, x^2
  double to_corner = 0;          ///< x there; distances from the nearest place, negative towards the corner

  Vec3d position(double x) const { return terms[0] + x * (terms[1] + x * terms[2]); }
  Vec3d direction(double x) const { return terms[1] + 2 * x * terms[2]; }  ///< away from the corner
  double nearest(const Vec3d& place) const;  ///< x of the point nearest to a place, maybe beyond the corner
};

/// A corner of a line.
struct Corner {
  double t = 0;  ///< as LinePlace::t
  Leg before, after;
  Vec3d position;  ///< where the legs meet
};

/// Finds the corners of a line, of 25 degrees or more, from places of it that are about `scale` (object
/// units) apart, ascending in t. Smoothing by the scale spoils the places nearest to a corner. Those between
/// 1.4 and 5 scales from it are extrapolated as parabolas, which meet there at an angle; legs that leave out
/// other places around it have to agree where, and have to be nearer to the places there than the smoothed
/// line is, as they are not at bends wider than some scales. So corners need six scales to the next one or to
/// an end. O(n log n) for n places, and O(k^2) for k near a corner.
std::vector<Corner> corners_of(std::span<const LinePlace> places, double scale);

}  // namespace burin
