// Functions of a smoothed surface, pixel by pixel. Derivatives are central differences of smoothed values.
#include <burin/feature/level_image.h>

#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// Where the chart folds or is compressed more than this, derivatives mean nothing.
constexpr float least_share_of_area = 0.01F;

Vec3f vector_at(const SmoothedImage& image, std::size_t channel, int column, int row) {
  return {image.at(channel, column, row), image.at(channel + 1, column, row),
          image.at(channel + 2, column, row)};
}

/// Derivatives of a vector of the image along t and d, per pixel.
struct Slopes {
  Vec3f along_t, along_d;
};

Slopes slopes_at(const SmoothedImage& image, std::size_t channel, int column, int row) {
  const auto at = [&](int i, int j) { return vector_at(image, channel, column + i, row + j); };
  return {(at(1, 0) - at(-1, 0)) / 2, (at(0, 1) - at(0, -1)) / 2};
}

bool is_known_around(const SmoothedImage& image, int column, int row) {
  const ChartGrid& grid = image.grid;
  if (column < 1 || row < 1 || column + 1 >= grid.columns || row + 1 >= grid.rows) return false;
  return image.known[grid.pixel(column, row)] && image.known[grid.pixel(column - 1, row)] &&
         image.known[grid.pixel(column + 1, row)] && image.known[grid.pixel(column, row - 1)] &&
         image.known[grid.pixel(column, row + 1)];
}

/// The greatest eigenvalue of the Weingarten map, from the first and second fundamental forms.
float greatest_curvature(const Slopes& position, const Slopes& normal, float sign) {
  const float e = position.along_t.squaredNorm(), g = position.along_d.squaredNorm(),
              f = position.along_t.dot(position.along_d);
  const float area = e * g - f * f;
  if (!(area > least_share_of_area * g * g)) return unknown;
  const float l = sign * normal.along_t.dot(position.along_t),
              n = sign * normal.along_d.dot(position.along_d);
  const float m = sign * (normal.along_t.dot(position.along_d) + normal.along_d.dot(position.along_t)) / 2;
  const float mean = (e * n - 2 * f * m + g * l) / (2 * area), gauss = (l * n - m * m) / area;
  return mean + std::sqrt(std::max(mean * mean - gauss, 0.F));
}

/// The components along t and d, per pixel, of the projection of a direction onto the tangent plane; nothing
/// where the chart folds.
std::optional<Vec2f> projected(const Slopes& position, const Vec3f& direction) {
  const float e = position.along_t.squaredNorm(), g = position.along_d.squaredNorm(),
              f = position.along_t.dot(position.along_d);
  const float area = e * g - f * f;
  if (!(area > least_share_of_area * g * g)) return std::nullopt;
  const float t = direction.dot(position.along_t), d = direction.dot(position.along_d);
  return Vec2f((g * t - f * d) / area, (e * d - f * t) / area);
}

template <class Value>
LevelImage level_image(const SmoothedImage& image, const Value& value) {
  LevelImage result{image.grid, std::vector<float>(image.grid.size(), unknown)};
  for (int column = 0; column < image.grid.columns; ++column)
    for (int row = 0; row < image.grid.rows; ++row)
      result.values[image.grid.pixel(column, row)] = value(column, row);
  return result;
}

}  // namespace

std::vector<float> geometry_of(const ChartSamples& samples, Vec3f ChartSample::*normal) {
  std::vector<float> values;
  values.reserve(geometry_channels * samples.all().size());
  for (const ChartSample& sample : samples.all()) {
    values.insert(values.end(), sample.position.begin(), sample.position.end());
    values.insert(values.end(), (sample.*normal).begin(), (sample.*normal).end());
  }
  return values;
}

LevelImage curvature_image(const SmoothedImage& geometry, float sign) {
  return level_image(geometry, [&](int column, int row) {
    if (!is_known_around(geometry, column, row)) return unknown;
    return greatest_curvature(slopes_at(geometry, 0, column, row), slopes_at(geometry, 3, column, row), sign);
  });
}

LevelImage facing_image(const SmoothedImage& geometry, const Vec3f& origin, const Viewpoint& view) {
  return level_image(geometry, [&](int column, int row) {
    if (!geometry.known[geometry.grid.pixel(column, row)]) return unknown;
    const Vec3f normal = vector_at(geometry, 3, column, row);
    const float length = normal.norm();
    const Vec3f direction = to_viewer(view, vector_at(geometry, 0, column, row) + origin);
    return length > 0 ? normal.dot(direction) / length : unknown;
  });
}

std::optional<Vec2f> radial_direction(const SmoothedImage& geometry, const Vec3f& origin,
                                      const Viewpoint& view, int column, int row) {
  if (!is_known_around(geometry, column, row)) return std::nullopt;
  const Vec3f direction = to_viewer(view, vector_at(geometry, 0, column, row) + origin);
  return projected(slopes_at(geometry, 0, column, row), direction);
}

LevelImage radial_image(const SmoothedImage& geometry, const Vec3f& origin, const Viewpoint& view) {
  const auto direction_at = [&](int column, int row) {
    return radial_direction(geometry, origin, view, column, row);
  };
  const LevelImage all = level_image(geometry, [&](int column, int row) {
    const auto w = direction_at(column, row);
    if (!w) return unknown;
    const Slopes position = slopes_at(geometry, 0, column, row), normal = slopes_at(geometry, 3, column, row);
    const Vec3f step = w->x() * position.along_t + w->y() * position.along_d;
    const Vec3f turned = w->x() * normal.along_t + w->y() * normal.along_d;
    const float length = step.squaredNorm();
    return length > 0 ? turned.dot(step) / length : unknown;
  });
  return level_image(geometry, [&](int column, int row) {
    const auto w = direction_at(column, row);
    if (!w) return unknown;
    const float rise = w->x() * (all.at(column + 1, row) - all.at(column - 1, row)) +
                       w->y() * (all.at(column, row + 1) - all.at(column, row - 1));
    return rise > 0 ? all.at(column, row) : unknown;
  });
}

LevelImage channel_image(const SmoothedImage& image, float sign) {
  return level_image(image, [&](int column, int row) {
    return image.known[image.grid.pixel(column, row)] ? sign * image.at(0, column, row) : unknown;
  });
}

Vec3f to_viewer(const Viewpoint& view, const Vec3f& position) {
  return way_to_viewer(view, position).normalized().cast<float>();
}

Vec3d way_to_viewer(const Viewpoint& view, const Vec3f& position) {
  return view.is_eye ? Vec3d(view.at - position.cast<double>()) : Vec3d(-view.at.normalized());
}

}  // namespace burin
