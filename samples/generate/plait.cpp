// A strand swings to the sides once in a period and up and down twice; the three are a third of a
// period apart.
#include "plait.h"

#include <burin/math/elementary.h>

#include <array>
#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

constexpr int plait_steps = 24, sides = 10;
constexpr double plait_period = 2.6, swing = 0.62, rise = 0.25, thickness = 0.21;
constexpr double turn = 2 * std::numbers::pi;

/// A ring around a strand in a plane across the plait, which it meets at an angle, so that the ring is longer
/// in the direction in which the strand leans.
void add_ring(double phase, double x, PolygonMesh& mesh) {
  const std::array<double, 2> middle{swing * math::sin(phase), rise * math::sin(2 * phase)};
  const std::array<double, 2> slope{swing * turn / plait_period * math::cos(phase),
                                    2 * rise * turn / plait_period * math::cos(2 * phase)};
  const double squared = slope[0] * slope[0] + slope[1] * slope[1], lean = std::sqrt(1 + squared) - 1;
  for (int side = 0; side < sides; ++side) {
    const double angle = turn * side / sides, a = thickness * math::cos(angle),
                 b = thickness * math::sin(angle);
    const double longer = squared > 0 ? lean * (a * slope[0] + b * slope[1]) / squared : 0;
    const double left = middle[0] + a + longer * slope[0], up = middle[1] + b + longer * slope[1];
    mesh.positions.push_back(Vec3d(x, up, -left).cast<float>());
  }
}

void add_strand(double phase, PolygonMesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  for (int step = 0; step <= plait_steps; ++step)
    add_ring(phase + turn * (step % plait_steps) / plait_steps, plait_period * step / plait_steps, mesh);
  for (int step = 0; step < plait_steps; ++step) {
    for (int side = 0; side < sides; ++side) {
      const auto at = [&](int along, int around) {
        return first + static_cast<Index>((step + along) * sides + (side + around) % sides);
      };
      mesh.face_sizes.push_back(4);
      mesh.face_vertices.insert(mesh.face_vertices.end(), {at(0, 0), at(0, 1), at(1, 1), at(1, 0)});
    }
  }
}

}  // namespace

PolygonMesh plait() {
  PolygonMesh mesh;
  for (int strand = 0; strand < 3; ++strand) add_strand(turn * strand / 3, mesh);
  return mesh;
}

}  // namespace burin::samples
