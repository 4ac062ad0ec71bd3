// Filters a stamp over an elliptic area: two neighbouring levels of the mip pyramid are averaged over the
// ellipse and mixed. The filter is anisotropic, in the manner of the elliptical weighted average [Heckbert
// 1989], with a constant weight over the ellipse. A sample visits at most about 64 by 64 texels per level.
#include <burin/stamp/area_filter.h>

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// The width of an ellipse, in texels, above which coarser levels are used.
constexpr double finest = 4;
/// The length of an ellipse, in texels, above which coarser levels are used. On no level is an ellipse longer
/// than twice that, which bounds the cost of a sample.
constexpr double longest = 32;
/// The least square of a half axis, in texels squared, so that every ellipse has an area.
constexpr double least = 1e-8;

/// The points x with x^T A^-1 x <= 1 for the symmetric matrix A = (xx, xy; xy, yy), in texels of a level.
struct Ellipse {
  double xx, xy, yy;
};

struct HalfAxes {
  double short_square, long_square;
};

HalfAxes half_axes(const Ellipse& e) {
  const double mean = (e.xx + e.yy) / 2, half = (e.xx - e.yy) / 2;
  const double long_square = mean + std::sqrt(half * half + e.xy * e.xy);
  const double determinant = e.xx * e.yy - e.xy * e.xy;
  return {long_square > 0 ? determinant / long_square : 0, long_square};
}

Ellipse inscribed(const SampleArea& area, int width, int height) {
  const double ax = area.along_u / 2.0 * width, ay = area.along_v / 2.0 * height;
  const double bx = area.across_u / 2.0 * width, by = area.across_v / 2.0 * height;
  return {ax * ax + bx * bx, ax * ay + bx * by, ay * ay + by * by};
}

/// The ellipse with both half axes extended to at least sqrt(least).
Ellipse with_area(const Ellipse& e) {
  const auto [short_square, long_square] = half_axes(e);
  if (short_square >= least) return e;
  if (long_square <= least) return {least, 0, least};
  const double gain = (least - short_square) / (long_square - short_square);
  return {e.xx + gain * (long_square - e.xx), e.xy - gain * e.xy, e.yy + gain * (long_square - e.yy)};
}

/// The ellipse to average over on a level, for an ellipse in texels of the stamp. A texel of the level is
/// already the mean of stretch_x * stretch_y texels and is interpolated bilinearly. The variances of that box
/// and tent, stretch^2 / 12 + stretch^2 / 6 minus their values at stretch 1, are subtracted from the variance
/// of the ellipse, which is (half axis)^2 / 4.
Ellipse on_level(const Ellipse& e, double stretch_x, double stretch_y) {
  const auto done = [](double stretch) { return 1 - 1 / (stretch * stretch); };
  return with_area({e.xx / (stretch_x * stretch_x) - done(stretch_x), e.xy / (stretch_x * stretch_y),
                    e.yy / (stretch_y * stretch_y) - done(stretch_y)});
}

/// The finer of two levels to mix, and the weight of the coarser.
struct LevelSpan {
  std::size_t level;
  double weight;
};

/// The levels for an ellipse of this width in units of the finest level's width. The weight is linear in the
/// width, not in its logarithm, so that it has the same bits on every machine.
LevelSpan level_span(double width, std::size_t levels) {
  if (!(width > 1)) return {0, 0};
  const auto level = static_cast<std::size_t>(std::bit_cast<std::uint64_t>(width) >> 52) - 1023;
  if (level + 1 >= levels) return {levels - 1, 0};
  return {level, width / static_cast<double>(std::uint64_t{1} << level) - 1};
}

/// The greatest whole number not above `place`. Does not call std::floor, which is slow on some processors.
std::ptrdiff_t whole_below(double place) {
  const auto whole = static_cast<std::ptrdiff_t>(place);
  return place < static_cast<double>(whole) ? whole - 1 : whole;
}

/// Numbers of the two lines in a row of texels.
using Pair = Eigen::Array2d;

/// One channel of a level, with texel centres at whole numbers.
class Texels {
 public:
  Texels(const StampImage& image, int channel) : image_(image), first_(image.texels.data() + channel) {}

  /// The means of the bilinear image over the lines from (begin, y) to (end, y), for y from `row` to row + 1.
  /// The means of empty lines are not numbers.
  Pair line_means(std::ptrdiff_t row, const Pair& begin, const Pair& end, const Pair& y) const {
    const Rows rows{row_of(row), row_of(row + 1), y - static_cast<double>(row)};
    const std::ptrdiff_t first = whole_below(begin.minCoeff());
    const double last = end.maxCoeff();
    Pair sum = Pair::Zero(), left = values(rows, first);
    for (std::ptrdiff_t x = first; static_cast<double>(x) < last; ++x) {
      const Pair right = values(rows, x + 1);
      const Pair from = (begin - static_cast<double>(x)).max(0), to = (end - static_cast<double>(x)).min(1);
      sum += (to - from).max(0) * (left + (right - left) * ((from + to) / 2));
      left = right;
    }
    return sum / (end - begin);
  }

 private:
  /// Two rows of texels, null outside a black wrap's borders, and the weights of the second on both lines.
  struct Rows {
    const float *above, *below;
    Pair weight;
  };

  const float* row_of(std::ptrdiff_t row) const {
    const std::ptrdiff_t y = wrapped_index(row, image_.height, image_.wrap_v);
    return y == no_texel ? nullptr : first_ + y * image_.width * image_.channels;
  }

  Pair values(const Rows& rows, std::ptrdiff_t column) const {
    const std::ptrdiff_t x = wrapped_index(column, image_.width, image_.wrap_u);
    if (x == no_texel) return Pair::Zero();
    const double above = rows.above ? double{rows.above[x * image_.channels]} : 0;
    const double below = rows.below ? double{rows.below[x * image_.channels]} : 0;
    return above + (below - above) * rows.weight;
  }

  const StampImage& image_;
  const float* first_;
};

/// The mean of the bilinear image over the ellipse around (x, y): exact integrals along lines, and
/// Gauss-Legendre quadrature with two points per row of texels across them.
double ellipse_mean(const Texels& texels, double x, double y, const Ellipse& e) {
  const double height = std::sqrt(e.yy), slope = e.xy / e.yy;
  const double half_chord = std::sqrt(e.xx - slope * e.xy);
  constexpr double node = 0.57735026918962576;
  double sum = 0, weights = 0;
  for (std::ptrdiff_t row = whole_below(y - height); static_cast<double>(row) < y + height; ++row) {
    const auto top = static_cast<double>(row);
    const double low = std::max(top, y - height), high = std::min(top + 1, y + height);
    const Pair line = (low + high + Pair(-node, node) * (high - low)) / 2, away = (line - y) / height;
    const Pair chord = (1 - away.square()).max(0).sqrt(), weight = chord * (high - low);
    const Pair middle = x + slope * (line - y), half = half_chord * chord;
    const Pair means = texels.line_means(row, middle - half, middle + half, line);
    for (Eigen::Index i = 0; i < means.size(); ++i) {
      if (!(weight[i] > 0)) continue;
      sum += weight[i] * means[i];
      weights += weight[i];
    }
  }
  return sum / weights;
}

double level_mean(const MipPyramid& pyramid, std::size_t index, int channel, float u, float v,
                  const Ellipse& on_stamp) {
  const MipLevel& level = pyramid.levels[index];
  const StampImage& stamp = pyramid.stamp();
  Ellipse e = on_level(on_stamp, static_cast<double>(stamp.width) / level.width(),
                       static_cast<double>(stamp.height) / level.height());
  // The last level has no coarser one, so an ellipse that covers many copies of the image is shrunk there.
  const double shrink = longest * longest / half_axes(e).long_square;
  if (shrink < 1) e = with_area({e.xx * shrink, e.xy * shrink, e.yy * shrink});
  const double width = level.width(), height = level.height();
  const double x = wrapped_coordinate(u, stamp.wrap_u, (std::sqrt(e.xx) + 2) / width) * width;
  const double y = wrapped_coordinate(v, stamp.wrap_v, (std::sqrt(e.yy) + 2) / height) * height;
  return ellipse_mean(Texels(level.image, channel), x - 0.5 + level.ring_u, y - 0.5 + level.ring_v, e);
}

double pyramid_mean(const MipPyramid& pyramid, int channel, float u, float v, const Ellipse& e,
                    const HalfAxes& axes) {
  const double across = 2 * std::sqrt(std::max(axes.short_square, 0.0)),
               along = 2 * std::sqrt(axes.long_square);
  const auto [level, weight] = level_span(std::max(across / finest, along / longest), pyramid.levels.size());
  const double fine = level_mean(pyramid, level, channel, u, v, e);
  return weight > 0 ? fine * (1 - weight) + level_mean(pyramid, level + 1, channel, u, v, e) * weight : fine;
}

}  // namespace

float sample_area(const MipPyramid& pyramid, int channel, float u, float v, const SampleArea& area) {
  const Ellipse e = inscribed(area, pyramid.stamp().width, pyramid.stamp().height);
  if (!std::isfinite(e.xx + e.yy)) return std::numeric_limits<float>::quiet_NaN();
  const HalfAxes axes = half_axes(e);
  const auto point = [&] { return sample_bilinear(pyramid.stamp(), channel, u, v); };
  if (axes.long_square <= 0.25 || !std::isfinite(u) || !std::isfinite(v)) return point();
  const double mean = pyramid_mean(pyramid, channel, u, v, e, axes);
  const double share = 2 * std::sqrt(axes.long_square) - 1;
  return static_cast<float>(share < 1 ? point() * (1 - share) + mean * share : mean);
}

}  // namespace burin
