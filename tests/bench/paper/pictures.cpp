#include "pictures.h"

#include <algorithm>
#include <array>
#include <optional>

#include "host_stub/options/view.h"
#include "host_stub/pictures/checkerboard.h"
#include "host_stub/pictures/curve_overlay.h"
#include "host_stub/pictures/render.h"

namespace burin::paper {
namespace {

constexpr double squares_per_radius = 4;

/// Values at some vertices of a surface, clay elsewhere.
class Field {
 public:
  explicit Field(const Surface& surface) : surface_(surface), values_(surface.vertex_count()) {}

  void set(Index vertex, const Vec2f& value) { values_[vertex] = value; }

  std::optional<Vec2f> at(const SurfacePoint& point) const {
    const auto& [a, b, c] = point.corners;
    const auto& [wa, wb, wc] = point.weights;
    if (!values_[a] || !values_[b] || !values_[c]) return std::nullopt;
    return Vec2f(wa * *values_[a] + wb * *values_[b] + wc * *values_[c]);
  }

 private:
  const Surface& surface_;
  std::vector<std::optional<Vec2f>> values_;
};

Picture draw(const Subject& subject, const Albedo& albedo) {
  ViewOptions options;
  options.width = subject.scene->picture_width;
  options.height = options.width * 3 / 4;
  const Camera camera = stroke_view(subject.scene->surface, {&subject.curve, 1}, subject.radius, options);
  Picture picture = render(subject.scene->surface, subject.scene->picker, camera, albedo);
  draw_curve(picture, camera, subject.scene->picker, subject.curve, 0);
  return picture;
}

}  // namespace

Picture checkerboard_picture(const Subject& subject, const Parameterization& places) {
  Field field(subject.scene->surface);
  const double scale = squares_per_radius / subject.radius;
  for (std::size_t local = 0; local < subject.region.vertices.size(); ++local) {
    const Vec2d place = scale * places.row(static_cast<Eigen::Index>(local));
    field.set(subject.region.vertices[local], place.cast<float>());
  }
  return draw(subject, [&](const SurfacePoint& point) {
    const auto place = field.at(point);
    return place ? checker_colour(place->x(), place->y()) : clay(point);
  });
}

Picture error_picture(const Subject& subject, const DistanceError& error, double worst) {
  Field field(subject.scene->surface);
  for (std::size_t i = 0; i < error.vertices.size(); ++i)
    field.set(error.vertices[i], Vec2f(static_cast<float>(error.errors[i] / worst), 0));
  return draw(subject, [&](const SurfacePoint& point) {
    const auto value = field.at(point);
    if (!value) return clay(point);
    const float share = std::min(1.F, value->x());
    return Vec3f((1 - share) * Vec3f(0.8F, 0.8F, 0.8F) + share * Vec3f(0.75F, 0.02F, 0.02F));
  });
}

}  // namespace burin::paper
