// Chooses an origin near the positions of a file, in O(n), so that floats relative to it keep the digits of
// the file.
#include <burin/surface/files/file_mesh.h>

#include <Eigen/Geometry>
#include <cmath>

namespace burin {
namespace {

/// Floats hold 24 bits of a coordinate. At this distance, in diagonals, 20 bits of the box's diagonal remain.
constexpr double farthest = 16;  ///< diagonals

/// The multiple of a power of two at or above `grain` that is nearest to `value`.
double rounded(double value, double grain) {
  int exponent = 0;
  std::frexp(grain, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent);
}

}  // namespace

Vec3d near_origin(const std::vector<Vec3d>& places) {
  Eigen::AlignedBox3d box;
  for (const Vec3d& place : places)
    if (place.allFinite()) box.extend(place);
  if (box.isEmpty()) return Vec3d::Zero();
  const double diagonal = box.diagonal().norm();
  const Vec3d middle = box.center();
  if (!(diagonal > 0 && std::isfinite(diagonal)) || !(middle.cwiseAbs().maxCoeff() > farthest * diagonal))
    return Vec3d::Zero();
  return middle.unaryExpr([&](double coordinate) { return rounded(coordinate, diagonal); });
}

std::vector<Vec3f> positions_from(const std::vector<Vec3d>& places, const Vec3d& origin) {
  std::vector<Vec3f> positions(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) positions[i] = (places[i] - origin).cast<float>();
  return positions;
}

}  // namespace burin
