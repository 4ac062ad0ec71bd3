#include "drawings.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace burin::paper {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Vec2d> sampled(int count, const std::function<Vec2d(double)>& curve) {
  std::vector<Vec2d> points;
  for (int i = 0; i <= count; ++i) points.push_back(curve(static_cast<double>(i) / count));
  return points;
}

/// Along x from -3 to 3 radii, `turns` waves of this height.
std::vector<Vec2d> wave(double height, double turns) {
  return sampled(80, [=](double s) { return Vec2d(-3 + 6 * s, height * std::sin(2 * pi * turns * s)); });
}

/// Straight runs with corners as tight as a pen makes them.
std::vector<Vec2d> zigzag(double height, int runs) {
  return sampled(120, [=](double s) {
    const double at = s * runs, share = at - std::floor(at);
    const double sign = static_cast<int>(std::floor(at)) % 2 == 0 ? 1 : -1;
    return Vec2d(-3 + 6 * s, sign * height * (2 * share - 1));
  });
}

/// Points that go forward, around a half circle, and back.
std::vector<Vec2d> around(double turning_radius, double run) {
  const double arc = pi * turning_radius, whole = 2 * run + arc;
  return sampled(120, [=](double share) {
    const double s = share * whole;
    if (s < run) return Vec2d(s - run, turning_radius);
    if (s > run + arc) return Vec2d(run + arc - s, -turning_radius);
    const double angle = pi / 2 - (s - run) / turning_radius;
    return Vec2d(turning_radius * std::cos(angle), turning_radius * std::sin(angle));
  });
}

}  // namespace

Drawing gentle_s() {
  return {"gentle S", "spot_control_mesh", {0.5F, 0.36F, 0.64F}, {-1, -0.15F, 0}, 0.04, wave(0.9, 1)};
}

Drawing bends() {
  return {"bends", "stanford-bunny", {0.66F, 0.38F, 0.5F}, {0, -0.2F, -1}, 0.04, wave(0.9, 2)};
}

Drawing sharp_bends() {
  return {"sharp bends", "ewer", {0.5F, 0.4F, 0.5F}, {-0.3F, -0.1F, -1}, 0.03, zigzag(1.2, 4)};
}

Drawing gentle_on_ewer() {
  return {"gentle S on the ewer", "ewer", {0.5F, 0.4F, 0.5F}, {-0.3F, -0.1F, -1}, 0.04, wave(0.9, 1)};
}

Drawing hairpin() {
  return {"hairpin", "ewer", {0.5F, 0.4F, 0.5F}, {-0.3F, -0.1F, -1}, 0.05, around(0.5, 2)};
}

}  // namespace burin::paper
