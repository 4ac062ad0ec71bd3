// The path of a feature: the best one from pixel to pixel, placed exactly by parabolas through pixels or by
// fits to the chart's nodes, and smoothed.
#include <burin/feature/best_path.h>
#include <burin/feature/found_path.h>
#include <burin/feature/significance.h>
#include <burin/feature/smooth_offsets.h>
#include <burin/math/median.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Divides the weights by their median, of those above 0.
void normalize(std::vector<WeightedValue>& values) {
  std::vector<double> weights;
  for (const WeightedValue& value : values)
    if (value.weight > 0) weights.push_back(value.weight);
  if (weights.empty()) return;
  const double unit = math::median(weights);
  for (WeightedValue& value : values) value.weight /= unit;
}

class PathFinder {
 public:
  PathFinder(const SampledFeature& sampled, const ColumnRange& columns, const PathSearch& search)
      : sampled_(sampled), score_(sampled.score()), columns_(columns), search_(search) {}

  std::vector<PathColumn> find() {
    const std::vector<int> rows = best_path(score_, columns_.first, columns_.count, {});
    std::vector<PathColumn> path(rows.size());
    const std::vector<WeightedValue> found = fitted(rows);
    std::vector<WeightedValue> wanted = found;
    normalize(wanted);
    const std::vector<bool> placed = near_fits(wanted);
    hold_between(wanted, rows);
    const double cube = search_.stiff * search_.stiff * search_.stiff, stiffness = cube * cube;
    const std::vector<double> smooth = smooth_offsets(wanted, search_.bends, stiffness);
    for (std::size_t i = 0; i < path.size(); ++i)
      path[i] = {.row = smooth[i], .place = found[i].value, .has_place = found[i].weight > 0};
    const std::vector<double> all = means_along(significances(smooth, found), search_.window);
    for (std::size_t i = 0; i < path.size(); ++i) path[i].significance = placed[i] ? all[i] : 0;
    return path;
  }

 private:
  /// Columns from one that is placed to the next.
  std::size_t fit_stride() const {
    if (consists_of_edges(sampled_.kind())) return 1;
    return std::max<std::size_t>(1, static_cast<std::size_t>(search_.smoothing.rows));
  }

  /// Places every few columns by a fit, those of edges all.
  std::vector<WeightedValue> fitted(const std::vector<int>& rows) const {
    constexpr double rounding = 0.02;  // rows; fits are not more precise than that
    const std::size_t stride = fit_stride();
    std::vector<WeightedValue> wanted(rows.size());
    double near = rows[0];
    for (std::size_t i = 0; i < rows.size(); i += stride) {
      // The place before is nearer to this one than the pixel is, where the line goes along the stroke.
      const double from = std::abs(near - rows[i]) < 1 ? near : rows[i];
      const auto refined = sampled_.refine(columns_.first + static_cast<int>(i), from, search_.fits);
      near = refined ? from + refined->offset : rows[i];
      if (refined) wanted[i] = {near, 1 / (refined->variance + rounding * rounding)};
    }
    return wanted;
  }

  /// The significance of each column by itself.
  std::vector<double> significances(std::span<const double> path,
                                    const std::vector<WeightedValue>& found) const {
    if (is_seen(sampled_.kind())) return exactness(found);
    if (consists_of_edges(sampled_.kind())) {
      constexpr double of_whole_line = 6;
      std::vector<double> result = levels_on(sampled_.level(), path, columns_.first);
      for (double& value : result) value *= of_whole_line;
      return result;
    }
    const ContrastWindow window{.beside = 1.75 * search_.smoothing.rows,
                                .apart = static_cast<int>(std::lround(2 * search_.smoothing.columns)),
                                .one_side_is_enough = search_.one_side_is_enough};
    return crest_contrasts(sampled_.level(), path, columns_.first, window);
  }

  /// The scale over the standard error of the place, of the nearest column before that was placed.
  std::vector<double> exactness(const std::vector<WeightedValue>& found) const {
    constexpr double most = 50;  // so that a few exact places do not stand for others
    std::vector<double> result;
    double last = 0;
    const std::size_t stride = fit_stride();
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i % stride == 0) last = std::min(search_.smoothing.rows * std::sqrt(found[i].weight), most);
      result.push_back(last);
    }
    return result;
  }

  /// Whether there is a placed column near each.
  std::vector<bool> near_fits(const std::vector<WeightedValue>& wanted) const {
    const auto reach = static_cast<std::size_t>(std::ceil(search_.bridged * search_.smoothing.rows));
    std::vector<bool> near(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!(wanted[i].weight > 0)) continue;
      const std::size_t end = std::min(i + reach + 1, wanted.size());
      for (std::size_t k = i - std::min(i, reach); k < end; ++k) near[k] = true;
    }
    return near;
  }

  /// Where nothing else is known the path stays near its pixels.
  static void hold_between(std::vector<WeightedValue>& wanted, const std::vector<int>& rows) {
    constexpr double weak = 1e-3;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!(wanted[i].weight > 0)) wanted[i] = {static_cast<double>(rows[i]), weak};
  }

  const SampledFeature& sampled_;
  LevelImage score_;
  ColumnRange columns_;
  const PathSearch& search_;
};

}  // namespace

std::vector<PathColumn> find_path(const SampledFeature& sampled, const ColumnRange& columns,
                                  const PathSearch& search) {
  return PathFinder(sampled, columns, search).find();
}

}  // namespace burin
