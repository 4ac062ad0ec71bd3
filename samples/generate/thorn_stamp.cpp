// Computes the vector displacement map of a thorn.
#include <burin/math/elementary.h>

#include "thorn_stamp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "exr_file.h"

namespace burin::samples {

namespace {

constexpr int thorn_size = 96;  // texels each way

// Lengths are in halves of the stamp's width.
constexpr double foot = .96;  // radius of the disc that is moved
constexpr double bend_radius = .62;
constexpr double bend_angle = 2.45;  // turn of the thorn's axis from its foot to its tip, radians

/// The radius of the thorn at s, from 0 at its foot to 1 at its tip: flared, then slender, then rounded.
double thickness(double s) {
  const double flare = math::pow(1 - s, 5);
  return (.30 * (1 - .75 * s) * (1 - flare) + foot * flare) * std::sqrt(1 - math::pow(s, 6));
}

/// The position to which the point (x, y) of the disc moves: circles around the middle become rings around
/// the thorn's axis, which is a circular arc in the plane y = 0 through the origin.
std::array<double, 3> on_thorn(double x, double y) {
  const double rho = math::hypot(x, y);
  if (rho >= foot) return {x, y, 0};
  const double s = 1 - rho / foot, angle = bend_angle * s * s * (1.5 - .5 * s);
  const double right = rho > 0 ? x / rho : 0, up = rho > 0 ? y / rho : 0, radius = thickness(s);
  const double from_axis = bend_radius - radius * right;  // distance from the bend's centre
  const double lift = .35 * math::sin(s * std::numbers::pi / 2);
  return {bend_radius - from_axis * math::cos(angle), radius * up, from_axis * math::sin(angle) + lift};
}

}  // namespace

void write_thorn(const std::filesystem::path& path) {
  std::vector<float> texels;
  for (int row = 0; row < thorn_size; ++row)
    for (int column = 0; column < thorn_size; ++column) {
      const double x = 2 * (column + .5) / thorn_size - 1, y = 1 - 2 * (row + .5) / thorn_size;
      const auto place = on_thorn(x, y);
      for (const double moved : {place[0] - x, place[1] - y, place[2]})
        texels.push_back(static_cast<float>(moved));
    }
  write_exr(path, thorn_size, thorn_size, {"R", "G", "B"}, texels);
}

}  // namespace burin::samples
