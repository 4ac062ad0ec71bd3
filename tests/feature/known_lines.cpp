#include "feature/known_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/closed_curve.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin::test {
namespace {

double gaussian(double x, double w) { return std::exp(-x * x / (2 * w * w)); }

/// How far meshes go on beyond the ends of lines.
double beyond(double w) { return 5 + 1.5 * w; }

}  // namespace

KnownLine ridge_in_plane(double w, double h, double bend, double reach, double length, std::uint32_t seed) {
  const double angle = length / bend;
  // The middle of the arc is at the origin, its centre at (0, bend).
  const auto place = [=](double along, double off) {
    const double at = (along - 0.5) * angle;
    return Vec3d((bend - off) * std::sin(at), bend - (bend - off) * std::cos(at), 0);
  };
  const auto off = [=](const Vec3d& x) { return bend - std::hypot(x.x(), x.y() - bend); };
  const double half = length / 2 + beyond(w), low = -reach - 6,
               high = reach + 6 + bend * (1 - std::cos(angle / 2));
  const PatchGrid grid{
      -half, half, low, high, static_cast<int>(2 * half * 1.15), static_cast<int>((high - low) * 1.15),
      false, 0.3,  0.3, seed};
  return {shuffled(patch(grid,
                         [=](double x, double y) {
                           return Vec3d(x, y, h * gaussian(off({x, y, 0}), w));
                         }),
                   seed + 1),
          [=](double s) { return Vec3d(place(s, 0) + Vec3d(0, 0, h)); },
          [=](double s, double to_left) {
            return Vec3d(place(s, to_left) + Vec3d(0, 0, h * gaussian(to_left, w)));
          },
          [=](const Vec3d& x) { return std::abs(off(x)); }};
}

KnownLine ridge_on_sphere(double w, double h, double sphere_radius, double polar, double reach, double length,
                          std::uint32_t seed) {
  const double angle = length / (sphere_radius * std::sin(polar));
  const auto place = [=](double longitude, double from_pole) {
    const double r = sphere_radius + h * gaussian(sphere_radius * (from_pole - polar), w);
    return Vec3d(r * std::sin(from_pole) * std::cos(longitude), r * std::sin(from_pole) * std::sin(longitude),
                 r * std::cos(from_pole));
  };
  const double least = polar - (reach + 6) / sphere_radius, most = polar + (reach + 6) / sphere_radius;
  const double half = angle / 2 + beyond(w) / (sphere_radius * std::sin(polar));
  // Outward normals: longitude runs against the polar angle.
  const PatchGrid grid{-half,
                       half,
                       -most,
                       -least,
                       static_cast<int>(2 * half * sphere_radius * std::sin(polar) * 1.15),
                       static_cast<int>((most - least) * sphere_radius * 1.15),
                       false,
                       0.3,
                       0.3,
                       seed};
  return {shuffled(patch(grid, [=](double u, double v) { return place(u, -v); }), seed + 1),
          [=](double s) { return place((s - 0.5) * angle, polar); },
          [=](double s, double to_left) { return place((s - 0.5) * angle, polar - to_left / sphere_radius); },
          [=](const Vec3d& x) { return sphere_radius * std::abs(std::acos(x.z() / x.norm()) - polar); }};
}

KnownLine ridge_on_saddle(double w, double h, double size, double reach, double length, std::uint32_t seed) {
  const auto place = [=](double x, double y) {
    const Vec3d normal = Vec3d(-x / size, y / size, 1).normalized();
    return Vec3d(Vec3d(x, y, (x * x - y * y) / (2 * size)) + h * gaussian(y, w) * normal);
  };
  const double half = length / 2 + beyond(w), wide = reach + 6;
  const PatchGrid grid{
      -half, half, -wide, wide, static_cast<int>(2 * half * 1.15), static_cast<int>(2 * wide * 1.15),
      false, 0.3,  0.3,   seed};
  return {shuffled(patch(grid, place), seed + 1), [=](double s) { return place(length * (s - 0.5), 0); },
          [=](double s, double to_left) { return place(length * (s - 0.5), to_left); },
          [=](const Vec3d& x) { return std::abs(x.y()); }};
}

void add_noise(TriangleMesh& mesh, double deviation, std::uint32_t seed) {
  const Surface surface = make_surface(mesh);
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, static_cast<float>(deviation));
  for (Index v = 0; v < surface.vertex_count(); ++v)
    mesh.positions[surface.source_vertex[v]] += noise(random) * surface.normals[v];
}

SnapScene::SnapScene(TriangleMesh mesh)
    : surface(make_surface(std::move(mesh))), picker(surface), snapper(surface, picker) {}

SnapResult SnapScene::snap(const std::vector<Vec3d>& pen, const Feature& feature,
                           const SnapOptions& options) {
  stroke = traced(surface, picker, options.radius, pen);
  return snapper.snap(stroke, feature, options);
}

SnapResult SnapScene::snap_closed(const std::vector<Vec3d>& pen, const Feature& feature,
                                  const SnapOptions& options) {
  stroke = traced(surface, picker, options.radius, pen);
  close(stroke);
  return snapper.snap(stroke, feature, options);
}

std::vector<double> distances(const SnapResult& result, const std::function<double(const Vec3d&)>& distance) {
  std::vector<double> all;
  for (std::size_t i = 0; i < result.curve.points.size(); ++i) {
    const double t = result.stroke_t[i];
    if (std::ranges::any_of(result.ranges, [&](const SnapRange& r) { return t >= r.from && t <= r.to; }) ||
        result.curve.closed)
      all.push_back(distance(result.curve.points[i].at.position.cast<double>()));
  }
  std::ranges::sort(all);
  return all;
}

double quantile(const std::vector<double>& ascending, double share) {
  if (ascending.empty()) return 1e9;
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

}  // namespace burin::test
