#pragma once
#include <burin/feature/chart_samples.h>

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace burin {

/// A window of an image, pixels.
struct FitWindow {
  Vec2d middle;
  Vec2d reach;  ///< half width along t and along d
};

/// Two functions of the place across the stroke: polynomials of fourth order in the share v of a window's
/// reach, from its middle, at the column of its middle.
class LocalFit {
 public:
  static constexpr int terms = 12;
  using Terms = Eigen::Matrix<double, terms, 2>;

  /// Fits both to the values of scattered samples in a window by least squares, weighted by their areas and
  /// by a bump. Terms of first and second order along the stroke let features run across the window at an
  /// angle or in a bend. Irregular samples do not bias it, as they do smoothed or interpolated values.
  /// Returns nothing if the samples do not determine it. Costs O(samples in the window's columns).
  static std::optional<LocalFit> make(const ChartSamples& samples, const FitWindow& window,
                                      const std::function<Vec2d(const ChartSample&)>& values);

  /// The derivatives of this order by v, at v.
  Vec2d derivative(int order, double v) const;

  /// The first derivatives by the share u along the stroke at the column of the window's middle, at v.
  Vec2d slope_along(double v) const;

  /// The variance of the second function's derivative of this order at v = 0, from the residuals of the fit.
  double variance(int order) const;

 private:
  Terms terms_;
  double residual_ = 0;                  ///< mean square of the second function's
  Eigen::Matrix<double, 5, 1> inverse_;  ///< diagonal of the inverse of the normal matrix, for powers of v
};

/// The root of f near 0 within [-most, most] by Newton's method; `f` returns value and slope.
std::optional<double> root_near_0(const std::function<Vec2d(double)>& f, double most);

}  // namespace burin
