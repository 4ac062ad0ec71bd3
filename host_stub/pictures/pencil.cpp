// Draws lines as dots half a pixel apart. A ray from the eye decides whether the surface hides a dot; each
// costs one query of the picker.
#include "pictures/pencil.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double line_radius = 1.2;  // pixels

/// The pixel coordinates of a position, or nothing behind the eye.
std::optional<Eigen::Vector2d> project(const Camera& camera, const Vec3d& position) {
  const Eigen::Vector4d clip = camera.projection * camera.view * position.homogeneous();
  if (clip.w() <= 0) return std::nullopt;
  return Eigen::Vector2d((0.5 + 0.5 * clip.x() / clip.w()) * camera.width,
                         (0.5 - 0.5 * clip.y() / clip.w()) * camera.height);
}

/// The number of dots of a line of so many pixels, in a picture whose sides sum up to `sides`.
int dots_of(double length, int sides) {
  return 1 + static_cast<int>(std::min(4.0 * sides, std::ceil(2 * length)));
}

}  // namespace

LineLayer::LineLayer(int width, int height)
    : width_(width),
      height_(height),
      share_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      ink_(share_.size()) {}

void LineLayer::add_dot(double x, double y, const Ink& ink) {
  const int reach = static_cast<int>(std::ceil(line_radius)) + 1;
  if (!(x > -reach && y > -reach && x < width_ + reach && y < height_ + reach)) return;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  for (int j = std::max(0, row - reach); j <= std::min(height_ - 1, row + reach); ++j) {
    for (int i = std::max(0, column - reach); i <= std::min(width_ - 1, column + reach); ++i) {
      const double distance = std::hypot(i + 0.5 - x, j + 0.5 - y);
      const auto covered = static_cast<float>(std::clamp(line_radius + 0.5 - distance, 0.0, 1.0));
      const std::size_t pixel =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i);
      if (covered <= share_[pixel]) continue;
      share_[pixel] = covered;
      ink_[pixel] = ink;
    }
  }
}

void LineLayer::add_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Ink& ink) {
  const int dots = dots_of((b - a).norm(), width_ + height_);
  for (int dot = 0; dot <= dots; ++dot) {
    const Eigen::Vector2d at = a + (b - a) * (static_cast<double>(dot) / dots);
    add_dot(at.x(), at.y(), ink);
  }
}

void LineLayer::blend(Picture& picture) const {
  for (std::size_t pixel = 0; pixel < share_.size(); ++pixel) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      std::uint8_t& byte = picture.rgb[3 * pixel + channel];
      const auto below = static_cast<float>(byte);
      byte = static_cast<std::uint8_t>(
          std::lround(below + share_[pixel] * (static_cast<float>(ink_[pixel][channel]) - below)));
    }
  }
}

bool Pencil::sees(const Eigen::Vector2d& pixel, const Vec3d& position) const {
  if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() > camera_.width || pixel.y() > camera_.height) return false;
  const Ray ray = pixel_ray(camera_, pixel.x(), pixel.y());
  const auto hit = picker_.pick(ray);
  const double distance = (position - ray.origin.cast<double>()).norm();
  return !hit || (hit->position - ray.origin).cast<double>().norm() > 0.99 * distance - depth_;
}

void Pencil::draw(const Vec3d& a, const Vec3d& b, const Ink& ink) {
  const auto from = project(camera_, a), to = project(camera_, b);
  if (!from || !to) return;
  const int dots = dots_of((*to - *from).norm(), camera_.width + camera_.height);
  for (int dot = 0; dot <= dots; ++dot) {
    const Vec3d position = a + (b - a) * (static_cast<double>(dot) / dots);
    const auto pixel = project(camera_, position);
    if (pixel && sees(*pixel, position)) layer_.add_dot(pixel->x(), pixel->y(), ink);
  }
}

}  // namespace burin
