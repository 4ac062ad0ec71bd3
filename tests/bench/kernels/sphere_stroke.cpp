#include "sphere_stroke.h"

#include <burin/base/error.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "support/gentle_stroke.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin::kernels {
namespace {

constexpr double length_radii = 6;
constexpr int finest_level = 9;

double vertices_at(int level) { return 10 * std::pow(4, level) + 2; }

/// The level on which the region of the stroke is at most a sixteenth of the sphere.
int level_for(std::size_t nodes) {
  int level = 0;
  while (level < finest_level && vertices_at(level) < 16 * static_cast<double>(nodes)) ++level;
  return level;
}

const Surface& sphere_surface(int level) {
  static std::map<int, Surface> surfaces;
  const auto found = surfaces.find(level);
  if (found != surfaces.end()) return found->second;
  return surfaces.emplace(level, make_surface(test::sphere(level, 0.2, 1))).first->second;
}

SphereStroke make_stroke(std::size_t nodes) {
  const int level = level_for(nodes);
  const Surface& surface = sphere_surface(level);
  // A band of six radii with a half disc at each end.
  const double area = 4 * std::numbers::pi * static_cast<double>(nodes) / vertices_at(level);
  const double radius = std::sqrt(area / (2 * length_radii + std::numbers::pi));
  const double length = length_radii * radius;
  std::mt19937 random(1);
  SphereStroke stroke{surface, radius, test::gentle_stroke(surface, Picker(surface), radius, length, random)};
  if (stroke.curve.length() < 0.9 * length) throw Error("the stroke left the sphere");
  return stroke;
}

}  // namespace

const SphereStroke& sphere_stroke(std::size_t nodes) {
  static std::map<std::size_t, SphereStroke> strokes;
  const auto found = strokes.find(nodes);
  if (found != strokes.end()) return found->second;
  return strokes.emplace(nodes, make_stroke(nodes)).first->second;
}

SurfaceCurve on_base(const SphereStroke& stroke, BaseSurface* base) {
  const Picker picker(stroke.surface);
  std::vector<Vec3d> samples;
  double next = 0;
  for (const CurvePoint& point : stroke.curve.points) {
    if (point.t < next) continue;
    samples.push_back(point.at.position.cast<double>());
    next = point.t + stroke.radius / 8;
  }
  return test::traced(CurveGround(stroke.surface, picker, base), picker, stroke.radius, samples);
}

}  // namespace burin::kernels
