// Parses the options of a view, and computes cameras that frame a surface or the curves of strokes.
#include "options/view.h"

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "options/options.h"

namespace burin {
namespace {

const Vec3d front_from_above(-0.45, -0.4, -1.0);

/// The requested up vector, or another axis if the camera looks along it.
Vec3d up_for(const Vec3d& direction, const ViewOptions& options) {
  const Vec3d up = options.up.value_or(Vec3d::UnitY());
  const bool along = direction.normalized().cross(up.normalized()).norm() < 1e-3;
  if (!along) return up;
  return std::abs(up.normalized().z()) < 0.9 ? Vec3d::UnitZ() : Vec3d::UnitY();
}

Camera frame(const Eigen::AlignedBox3d& box, const Vec3d& direction, const ViewOptions& options) {
  return framing_camera(box.min(), box.max(), direction, up_for(direction, options), options.width,
                        options.height, options.field_of_view * std::numbers::pi / 180);
}

}  // namespace

void add_view_options(CLI::App& command, ViewOptions& options) {
  add_vector_option(command, "--view", options.direction, "direction of sight");
  add_vector_option(command, "--up", options.up, "direction that is up in the picture (default 0,1,0)");
  command.add_option("--fov", options.field_of_view, "vertical field of view, degrees")
      ->check(CLI::Range(1.0, 150.0))
      ->capture_default_str();
  command.add_option("--width", options.width, "pixels")->check(CLI::Range(16, 16384))->capture_default_str();
  command.add_option("--height", options.height, "pixels")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
}

Camera whole_view(const Surface& surface, const ViewOptions& options) {
  Eigen::AlignedBox3d box;
  for (const Vec3f& position : surface.positions) box.extend(position.cast<double>());
  return frame(box, options.direction.value_or(front_from_above), options);
}

Camera stroke_view(const Surface& surface, std::span<const SurfaceCurve> curves, double radius,
                   const ViewOptions& options) {
  Eigen::AlignedBox3d box;
  Vec3d normals = Vec3d::Zero();
  std::size_t count = 0;
  for (const SurfaceCurve& curve : curves) {
    for (const CurvePoint& point : curve.points) {
      box.extend(point.at.position.cast<double>());
      normals += point.normal.cast<double>();
      ++count;
    }
  }
  if (count == 0) return whole_view(surface, options);
  const Vec3d margin = Vec3d::Constant(1.5 * radius);
  // Strokes that go around the object have no side from which to look.
  const bool one_sided = normals.norm() > 0.2 * static_cast<double>(count);
  return frame({box.min() - margin, box.max() + margin},
               options.direction.value_or(one_sided ? Vec3d(-normals) : front_from_above), options);
}

Camera fit_into(Camera camera, int longest) {
  const double scale = static_cast<double>(longest) / std::max(camera.width, camera.height);
  if (scale >= 1) return camera;
  camera.width = std::max(1, static_cast<int>(std::lround(camera.width * scale)));
  camera.height = std::max(1, static_cast<int>(std::lround(camera.height * scale)));
  return camera;
}

Camera recorded_view(std::span<const Recording> recordings, const Surface& surface,
                     std::span<const SurfaceCurve> curves, double radius, const ViewOptions& options) {
  const auto on_screen = std::ranges::find(recordings, StrokeSpace::screen, &Recording::space);
  if (on_screen == recordings.end() || !on_screen->camera || options.direction)
    return stroke_view(surface, curves, radius, options);
  return fit_into(*on_screen->camera, options.width);
}

}  // namespace burin
