// The functions of all kinds of features.
#include <burin/feature/best_path.h>
#include <burin/feature/sampled_feature.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

bool is_negative(FeatureKind kind) { return kind == FeatureKind::valley || kind == FeatureKind::low; }

SmoothedImage smoothed(const ChartSamples& samples, const Feature& feature, const Smoothing& smoothing) {
  if (!has_values(feature.kind)) {
    // Curvature is a slope of normals, which have to be those of the surface itself. The zero of n . v is
    // nearer to that of a smooth surface with the normals of vertices.
    const bool is_slope = feature.kind != FeatureKind::silhouette;
    return smoothed_image(samples,
                          geometry_of(samples, is_slope ? &ChartSample::mean_normal : &ChartSample::normal),
                          geometry_channels, smoothing);
  }
  std::vector<float> values;
  for (const ChartSample& sample : samples.all()) values.push_back(feature.values[sample.vertex]);
  return smoothed_image(samples, values, 1, smoothing);
}

}  // namespace

SampledFeature::SampledFeature(const Surface& surface, const Chart& chart, const ChartSamples& samples,
                               const Feature& feature, const Smoothing& smoothing)
    : surface_(surface), samples_(samples), feature_(feature), smoothing_(smoothing) {
  if (consists_of_edges(feature.kind))
    edges_ = line_edges(surface, chart, samples.grid(), feature);
  else
    smoothed_ = smoothed(samples, feature, smoothing);
  level_ = make_level();
}

LevelImage SampledFeature::make_level() {
  const float sign = is_negative(feature_.kind) ? -1 : 1;
  switch (feature_.kind) {
    case FeatureKind::border:
    case FeatureKind::crease:
      return nearness_image(edges_, samples_.grid(), smoothing_.rows);
    case FeatureKind::silhouette:
      return facing_image(smoothed_, samples_.origin(), feature_.view);
    case FeatureKind::suggestive:
      return radial_image(smoothed_, samples_.origin(), feature_.view);
    case FeatureKind::high:
    case FeatureKind::low:
      return channel_image(smoothed_, sign);
    default:
      return curvature_image(smoothed_, sign);
  }
}

LevelImage SampledFeature::score() const {
  constexpr double deviations = 3;
  if (is_seen(feature_.kind)) return crossing_score(level_, deviations * smoothing_.rows);
  return crest_score(level_);
}

std::optional<SampledFeature::ExactRow> SampledFeature::refine(int column, double row, int fits) const {
  if (consists_of_edges(feature_.kind)) {
    const auto point = near_line(column, row);
    return point ? std::optional(ExactRow{point->row - row, 0}) : std::nullopt;
  }
  constexpr double centred = 0.03;  // deviations; a window that is nearer to its result counts as symmetric
  std::optional<ExactRow> found;
  double at = row;
  for (int i = 0; i < fits; ++i) {
    found = fit(column, at);
    if (!found) return std::nullopt;
    at += found->offset;
    if (std::abs(found->offset) < centred * smoothing_.rows) break;
  }
  return ExactRow{at - row, found->variance};
}

std::optional<SurfacePoint> SampledFeature::point_at(double column, double row) const {
  if (!consists_of_edges(feature_.kind)) return std::nullopt;
  const auto point = near_line(column, row);
  return point ? std::optional(point->at) : std::nullopt;
}

std::optional<LinePoint> SampledFeature::near_line(double column, double row) const {
  constexpr double deviations = 3;
  auto point = crossing_at(surface_, edges_, column, row);
  if (point && std::abs(point->row - row) > deviations * smoothing_.rows) point.reset();
  return point;
}

/// Fits the function around a row of a column and finds its landmark: the zero of n . v, the crest of a
/// value, or that of the curvature of the profile (y, z) across the stroke as functions of d. There the
/// slope of the curvature, y' z_ddd - z' y_ddd, is 0, whatever the axes of y and z.
std::optional<SampledFeature::ExactRow> SampledFeature::fit(int column, double row) const {
  const ChartGrid& grid = samples_.grid();
  const int nearest = std::clamp(static_cast<int>(std::lround(row)), 1, grid.rows - 2);
  if (!smoothed_.known[grid.pixel(column, nearest)]) return std::nullopt;
  constexpr double deviations = 3;  // of the bump's window, which has the variance of the image's Gaussian
  constexpr double share_along = 2. / 3;  // shorter along the stroke, so that the fit follows bends
  const double reach = deviations * smoothing_.rows;
  const FitWindow window{{column, row}, {share_along * reach * grid.step_d / grid.step_t, reach}};
  const bool is_profile = feature_.kind == FeatureKind::ridge || feature_.kind == FeatureKind::valley;
  const auto fit = is_profile ? fit_profile(window) : fit_values(window);
  if (!fit) return std::nullopt;
  const auto slope_of_curvature = [&](double v) {
    const Vec2d p1 = fit->derivative(1, v), p2 = fit->derivative(2, v), p3 = fit->derivative(3, v),
                p4 = fit->derivative(4, v);
    return Vec2d(p1[0] * p3[1] - p1[1] * p3[0],
                 p2[0] * p3[1] + p1[0] * p4[1] - p2[1] * p3[0] - p1[1] * p4[0]);
  };
  if (feature_.kind == FeatureKind::suggestive) return radial_row(*fit, window);
  const int order = is_profile ? 3 : has_values(feature_.kind) ? 1 : 0;
  const auto function = [&](double v) {
    if (is_profile) return slope_of_curvature(v);
    return Vec2d(fit->derivative(order, v)[1], fit->derivative(order + 1, v)[1]);
  };
  constexpr double farthest = 0.6;
  const auto v = root_near_0(function, farthest);
  if (!v) return std::nullopt;
  const double slope = function(*v)[1];
  // Heights have their fourth derivative positive on ridges, values their second one negative on crests.
  const bool is_rising = is_negative(feature_.kind) != is_profile;
  const int sign = feature_.kind == FeatureKind::silhouette ? 0 : is_rising ? 1 : -1;
  if (slope == 0 || sign * slope < 0) return std::nullopt;
  const double gain = is_profile ? fit->derivative(1, *v)[0] : 1;
  return ExactRow{*v * reach, gain * gain * fit->variance(order) / (slope * slope) * reach * reach};
}

std::optional<LocalFit> SampledFeature::fit_values(const FitWindow& window) const {
  return LocalFit::make(samples_, window, [&](const ChartSample& sample) {
    if (has_values(feature_.kind)) return Vec2d(0, static_cast<double>(feature_.values[sample.vertex]));
    // The ways to an eye are not shortened to unit vectors, whose lengths would add slopes of their own.
    const Vec3d way = way_to_viewer(feature_.view, sample.position + samples_.origin());
    return Vec2d(0, sample.normal.cast<double>().dot(way));
  });
}

/// Where n . v is least in the direction w of the view's projection, which is interpolated between rows.
std::optional<SampledFeature::ExactRow> SampledFeature::radial_row(const LocalFit& fit,
                                                                   const FitWindow& window) const {
  const int column = static_cast<int>(window.middle.x());
  const auto direction_at = [&](double v) -> std::optional<Vec2d> {
    const double row = window.middle.y() + v * window.reach.y(), below = std::floor(row);
    const int at = static_cast<int>(below);
    const auto low = radial_direction(smoothed_, samples_.origin(), feature_.view, column, at);
    const auto high = radial_direction(smoothed_, samples_.origin(), feature_.view, column, at + 1);
    if (!low || !high) return std::nullopt;
    const double share = row - below;
    const Vec2d w = (1 - share) * low->cast<double>() + share * high->cast<double>();
    return Vec2d(w.cwiseQuotient(window.reach));
  };
  const auto slope_at = [&](double v) {
    const auto w = direction_at(v);
    return w ? w->x() * fit.slope_along(v)[1] + w->y() * fit.derivative(1, v)[1]
             : std::numeric_limits<double>::quiet_NaN();
  };
  constexpr double step = 0.05, farthest = 0.6;
  const auto with_slope = [&](double v) {
    return Vec2d(slope_at(v), (slope_at(v + step) - slope_at(v - step)) / (2 * step));
  };
  const auto v = root_near_0(with_slope, farthest);
  const auto w = v ? direction_at(*v) : std::nullopt;
  if (!w) return std::nullopt;
  const double rise = with_slope(*v)[1], reach = window.reach.y();
  // The minimum has to lie across the stroke: along it the fit would not place it.
  if (!(rise * w->y() > 0)) return std::nullopt;
  return ExactRow{*v * reach, w->squaredNorm() * fit.variance(1) / (rise * rise) * reach * reach};
}

/// The profile of the surface across the stroke, along the direction of d and along the normal; object units.
std::optional<LocalFit> SampledFeature::fit_profile(const FitWindow& window) const {
  const int column = static_cast<int>(window.middle.x());
  const int row = std::clamp(static_cast<int>(std::lround(window.middle.y())), 1, samples_.grid().rows - 2);
  const auto vector_at = [&](std::size_t channel, int at_row) {
    return Vec3f(smoothed_.at(channel, column, at_row), smoothed_.at(channel + 1, column, at_row),
                 smoothed_.at(channel + 2, column, at_row));
  };
  const Vec3f middle = vector_at(0, row), normal = vector_at(3, row).normalized();
  const Vec3f across = unit_tangent(vector_at(0, row + 1) - vector_at(0, row - 1), normal);
  return LocalFit::make(samples_, window, [&](const ChartSample& sample) {
    const Vec3f from = sample.position - middle;
    return Vec2d(static_cast<double>(from.dot(across)), static_cast<double>(from.dot(normal)));
  });
}

}  // namespace burin
