// Draws a curve as dots half a pixel apart. A ray from the eye decides whether the surface hides a dot; each
// costs one query of the picker.
#include "pictures/curve_overlay.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

constexpr double line_radius = 1.2;  // pixels

/// The share of each pixel that the line covers. It is a maximum over dots, so that drawing twice does not
/// darken.
struct Coverage {
  int width, height;
  std::vector<float> share;

  void add_dot(double x, double y) {
    const int reach = static_cast<int>(std::ceil(line_radius)) + 1;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    for (int j = std::max(0, row - reach); j <= std::min(height - 1, row + reach); ++j) {
      for (int i = std::max(0, column - reach); i <= std::min(width - 1, column + reach); ++i) {
        const double distance = std::hypot(i + 0.5 - x, j + 0.5 - y);
        float& pixel = share[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(i)];
        pixel = std::max(pixel, static_cast<float>(std::clamp(line_radius + 0.5 - distance, 0.0, 1.0)));
      }
    }
  }
};

/// The pixel coordinates of a position, or nothing behind the eye.
std::optional<Eigen::Vector2d> project(const Camera& camera, const Vec3d& position) {
  const Eigen::Vector4d clip = camera.projection * camera.view * position.homogeneous();
  if (clip.w() <= 0) return std::nullopt;
  return Eigen::Vector2d((0.5 + 0.5 * clip.x() / clip.w()) * camera.width,
                         (0.5 - 0.5 * clip.y() / clip.w()) * camera.height);
}

/// Draws lines, except where the surface hides them.
struct Pencil {
  const Camera& camera;
  const Picker& picker;
  double depth;  // greatest depth below the surface at which a line is visible, object units
  Coverage coverage;

  bool sees(const Eigen::Vector2d& pixel, const Vec3d& position) const;
  void draw(const Vec3d& a, const Vec3d& b);
};

bool Pencil::sees(const Eigen::Vector2d& pixel, const Vec3d& position) const {
  if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() > camera.width || pixel.y() > camera.height) return false;
  const Ray ray = pixel_ray(camera, pixel.x(), pixel.y());
  const auto hit = picker.pick(ray);
  const double distance = (position - ray.origin.cast<double>()).norm();
  return !hit || (hit->position - ray.origin).cast<double>().norm() > 0.99 * distance - depth;
}

/// Draws the line from a to b as dots half a pixel apart.
void Pencil::draw(const Vec3d& a, const Vec3d& b) {
  const auto from = project(camera, a), to = project(camera, b);
  if (!from || !to) return;
  const double far = 4.0 * (camera.width + camera.height);
  const int dots = 1 + static_cast<int>(std::min(far, std::ceil(2 * (*to - *from).norm())));
  for (int dot = 0; dot <= dots; ++dot) {
    const Vec3d position = a + (b - a) * (static_cast<double>(dot) / dots);
    const auto pixel = project(camera, position);
    if (pixel && sees(*pixel, position)) coverage.add_dot(pixel->x(), pixel->y());
  }
}

void blend(Picture& picture, const Coverage& coverage) {
  constexpr float dark = 20;
  for (std::size_t pixel = 0; pixel < coverage.share.size(); ++pixel) {
    for (std::size_t byte = 3 * pixel; byte < 3 * pixel + 3; ++byte) {
      const auto below = static_cast<float>(picture.rgb[byte]);
      picture.rgb[byte] =
          static_cast<std::uint8_t>(std::lround(below + coverage.share[pixel] * (dark - below)));
    }
  }
}

}  // namespace

void draw_curve(Picture& picture, const Camera& camera, const Picker& picker, const SurfaceCurve& curve,
                double depth) {
  Pencil pencil{
      camera, picker, depth, {picture.width, picture.height, std::vector<float>(picture.rgb.size() / 3)}};
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    pencil.draw(curve.points[i].at.position.cast<double>(),
                curve.points[curve.next(i)].at.position.cast<double>());
  }
  blend(picture, pencil.coverage);
}

}  // namespace burin
