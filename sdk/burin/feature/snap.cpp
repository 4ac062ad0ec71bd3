// Snaps strokes to features, see the header. One iteration goes from the current curve to its chart, the
// image of the feature over it, the path in the image, and back to the surface.
#include <burin/base/error.h>
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/feature/chart_samples.h>
#include <burin/feature/cornered_run.h>
#include <burin/feature/edge_walk.h>
#include <burin/feature/found_path.h>
#include <burin/feature/path_on_surface.h>
#include <burin/feature/rough_chart.h>
#include <burin/feature/sampled_feature.h>
#include <burin/feature/snap.h>
#include <burin/feature/snapped_curve.h>
#include <burin/math/median.h>
#include <burin/stroke/curve/surface_curve.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

bool is_line(FeatureKind kind) { return kind == FeatureKind::silhouette || consists_of_edges(kind); }

/// The median, over some nodes of a chart, of the mean length of the edges at their vertices.
double typical_edge(const Surface& surface, const Chart& chart) {
  constexpr std::size_t most_samples = 256;
  const std::size_t step = chart.size() / most_samples + 1;
  std::vector<double> edges;
  for (std::size_t node = 0; node < chart.size(); node += step) {
    const Index vertex = chart.vertex[node];
    const auto neighbours = surface.neighbours[vertex];
    double sum = 0;
    for (const Index neighbour : neighbours)
      sum += static_cast<double>((surface.positions[neighbour] - surface.positions[vertex]).norm());
    if (!neighbours.empty()) edges.push_back(sum / static_cast<double>(neighbours.size()));
  }
  if (edges.empty()) return 0;
  return math::median(edges);
}

/// The arc length on the stroke that belongs to one on the current curve. On closed strokes both may go
/// beyond the length; `period` is the stroke's length, 0 for open ones.
double stroke_t_at(const SnappedCurve& current, double period, double t) {
  const SurfaceCurve& curve = current.curve;
  const double turns = curve.closed ? std::floor(t / curve.length()) : 0;
  const double within = t - turns * curve.length();
  const std::size_t from = segment_at(curve, within);
  const std::size_t to = curve.next(from);
  const double begin = curve.points[from].t, length = curve.segment_end(from) - begin;
  const double share = length > 0 ? std::clamp((within - begin) / length, 0., 1.) : 0;
  const double end_t = current.stroke_t[to] + (to < from ? period : 0);
  return current.stroke_t[from] + share * (end_t - current.stroke_t[from]) + turns * period;
}

SnappedCurve unmoved(const SurfaceCurve& stroke) {
  SnappedCurve curve{stroke, {}};
  for (const CurvePoint& point : stroke.points) curve.stroke_t.push_back(point.t);
  return curve;
}

/// The work on one stroke.
class Snapping {
 public:
  Snapping(const Surface& surface, const Picker& picker, StrokeChartBuilder& builder, RoughCharter& rough,
           const SurfaceCurve& stroke, const Feature& feature, const SnapOptions& options)
      : surface_(surface),
        picker_(picker),
        builder_(builder),
        rough_(rough),
        stroke_(stroke),
        feature_(feature),
        options_(options) {
    current_ = unmoved(stroke);
  }

  SnapResult run() {
    // A stroke shorter than a tenth of its width has no direction.
    constexpr double shortest_share = 0.1;
    if (stroke_.length() > shortest_share * options_.radius)
      for (int i = 0; i < options_.iterations; ++i)
        iterate(options_.is_near || i > 0, i + 1 == options_.iterations);
    result_.curve = std::move(current_.curve);
    result_.stroke_t = std::move(current_.stroke_t);
    result_.scale = scale_;
    result_.edge = edge_;
    result_.iterations = static_cast<int>(result_.images.size());
    measure();
    return std::move(result_);
  }

 private:
  void iterate(bool is_aligned, bool is_last) {
    // The path across a stroke that weaves stands out less; whether it does is decided in the last iteration.
    constexpr double share_before_last = 1. / 3;
    least_significance_ = (is_last ? 1 : share_before_last) * options_.significance;
    // Before the first chart the scale is not known, nor how far an aligned chart must reach.
    const double chart_radius = is_aligned && scale_ > 0 ? aligned_radius() : options_.radius;
    // Only the last chart decides how exact the result is. Silhouettes are narrow, and cross each other.
    const bool is_rough = !is_last && !is_aligned && !is_seen(feature_.kind);
    const Chart chart = is_rough ? rough_.chart(current_.curve, chart_radius)
                                 : builder_.chart(current_.curve, {.radius = chart_radius});
    if (scale_ == 0) {
      edge_ = typical_edge(surface_, chart);
      scale_ = chosen_scale();
    }
    const double radius = is_aligned ? aligned_radius() : options_.radius;
    // Once the stroke runs along the feature, smoothing along it removes noise and moves nothing.
    const double along = (is_aligned ? 2 : 1) * scale_;
    const ChartGrid grid = make_grid(radius, along);
    const ChartSamples samples(surface_, chart, grid);
    const Smoothing smoothing{along / grid.step_t, scale_ / grid.step_d};
    const SampledFeature sampled(surface_, chart, samples, feature_, smoothing);
    const ColumnRange all =
        stroke_.closed ? ColumnRange{0, grid.columns} : ColumnRange{grid.margin, grid.inner_columns()};
    // The spline must not flatten the swings of a stroke that weaves.
    const double stiff = (is_aligned ? 1 : 0.5) * scale_;
    constexpr double window_in_radii = 0.75;
    std::vector<double> bends(static_cast<std::size_t>(all.count));
    if (is_aligned) bends = bends_of(grid, all);
    std::vector<PathColumn> path = find_path(sampled, all,
                                             {.smoothing = smoothing,
                                              .window = window_in_radii * options_.radius / grid.step_t,
                                              .fits = is_aligned ? 2 : 1,
                                              .one_side_is_enough = !is_last,
                                              .bridged = options_.is_near ? 1. : 3.,
                                              .stiff = stiff / grid.step_t,
                                              .bends = bends});
    if (stroke_.closed) path = {path.begin() + grid.margin, path.end() - grid.margin};
    move_to(path, sampled, chart);
    note(sampled.level(), path);
  }

  /// Second differences of the current curve's positions at columns, in rows to its left.
  std::vector<double> bends_of(const ChartGrid& grid, const ColumnRange& columns) const {
    std::vector<double> bends(static_cast<std::size_t>(columns.count));
    const SurfaceCurve& curve = current_.curve;
    for (int i = curve.closed ? 0 : 1; i < columns.count - (curve.closed ? 0 : 1); ++i) {
      const double t = grid.t(columns.first + i);
      const Vec3d middle = stroke_position(curve, t);
      const Vec3d before = stroke_position(curve, t - grid.step_t),
                  after = stroke_position(curve, t + grid.step_t);
      const PenAt at = pen_at(curve, curve.closed ? wrapped_t(t, curve.length()) : t);
      const Vec3d left = at.normal.cast<double>().cross(after - before).normalized();
      bends[static_cast<std::size_t>(i)] = (before - 2 * middle + after).dot(left) / grid.step_d;
    }
    return bends;
  }

  /// Charts around a path that is near the feature need to reach beyond the windows of fits and of contrasts.
  double aligned_radius() const {
    constexpr double scales = 4;
    return std::min(options_.radius, scales * scale_);
  }

  double chosen_scale() const {
    if (options_.scale > 0) return std::min(options_.scale, options_.radius / 3);
    const double least = default_edges * edge_;
    const double wanted = is_line(feature_.kind) ? least : std::max(least, options_.radius / 6);
    return std::min(wanted > 0 ? wanted : options_.radius, options_.radius / 3);
  }

  ChartGrid make_grid(double radius, double along) const {
    constexpr double pixels_per_scale = 2, deviations = 3;
    const double margin =
        stroke_.closed ? std::max(deviations * along, 2 * options_.radius) : deviations * along;
    return chart_grid(current_.curve.length(), stroke_.closed, radius, scale_ / pixels_per_scale, margin);
  }

  /// Moves the current curve to the significant parts of a path.
  void move_to(const std::vector<PathColumn>& path, const SampledFeature& sampled, const Chart& chart) {
    const FinePath fine = finer_path(path, sampled.level().grid, edge_ / 2);
    const PathLookup lookup(surface_, chart, sampled, fine, edge_);
    std::vector<std::optional<SnappedPoint>> points(fine.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (fine.points[i].significance < least_significance_) continue;
      const double t = static_cast<double>(i) * fine.step;
      const auto at = lookup.at(t, fine.points[i].row);
      if (!at) continue;
      const SnappedPoint point{stroke_t_of(i, points.size(), t), *at};
      if (!is_held(point)) points[i] = point;
    }
    make_current(fine.points, points, fine.step, sampled.edges(), run_corners(path, sampled, lookup));
  }

  /// The corners of the path of a crest, which its smoothing has rounded.
  std::vector<RunCorner> run_corners(const std::vector<PathColumn>& path, const SampledFeature& sampled,
                                     const PathLookup& lookup) const {
    if (consists_of_edges(feature_.kind) || is_seen(feature_.kind)) return {};
    const ChartGrid& grid = sampled.level().grid;
    std::vector<LinePlace> places;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double t = static_cast<double>(i) * grid.step_t;
      if (!path[i].has_place) continue;
      const double smoothed_away = std::abs(path[i].row - path[i].place) * grid.step_d;
      if (const auto at = lookup.at(t, path[i].place))
        places.push_back({t, at->position.cast<double>(), smoothed_away});
    }
    if (stroke_.closed) add_turns(places);
    constexpr double rounded = 4;  // scales to either side
    std::vector<RunCorner> corners;
    for (const Corner& corner : corners_of(places, scale_))
      corners.push_back({corner, stroke_t_at(current_, period(), corner.t - rounded * scale_),
                         stroke_t_at(current_, period(), corner.t + rounded * scale_)});
    return corners;
  }

  /// Repeats the places of a closed line before and after it.
  void add_turns(std::vector<LinePlace>& places) const {
    const std::vector<LinePlace> once = places;
    for (const double turn : {-1, 1})
      for (const LinePlace& place : once)
        places.push_back({place.t + turn * current_.curve.length(), place.position, place.smoothed_away});
    std::ranges::sort(places, {}, &LinePlace::t);
  }

  /// The arc length on the stroke that belongs to one of `count` points of a path at t. Those at the ends of
  /// open strokes are exact, so that nothing of the stroke is left beyond them.
  double stroke_t_of(std::size_t point, std::size_t count, double t) const {
    if (!stroke_.closed && point == 0) return 0;
    if (!stroke_.closed && point + 1 == count) return stroke_.length();
    return stroke_t_at(current_, period(), t);
  }

  /// Whether a point is so near to an end that must stay where it is that the stroke cannot reach it.
  bool is_held(const SnappedPoint& point) const {
    if (!options_.fixed_ends || stroke_.closed) return false;
    return std::min(point.stroke_t, stroke_.length() - point.stroke_t) < 2 * moved(point);
  }

  void make_current(const std::vector<PathColumn>& path,
                    const std::vector<std::optional<SnappedPoint>>& points, double step,
                    const std::vector<LineEdge>& edges, const std::vector<RunCorner>& corners) {
    runs_.clear();
    result_.ranges.clear();
    const bool whole = stroke_.closed && std::ranges::all_of(path, [&](const PathColumn& column) {
                         return column.significance >= least_significance_;
                       });
    collect_runs(path, points, whole);
    if (runs_.empty()) {
      current_ = unmoved(stroke_);
    } else {
      constexpr double least_share = 0.1;
      if (!edges.empty()) {
        const EdgeWalk walk(surface_, edges);
        const WalkLimits limits{least_share * step, 2 * options_.radius};
        for (SnappedRun& run : runs_) run = walk.with_vertices(run, whole ? period() : 0, limits);
      }
      if (whole && std::ranges::any_of(corners, [](const RunCorner& at) { return at.from * at.to < 0; }))
        begin_half_a_turn_later(runs_.front());
      for (const RunCorner& corner : corners)
        for (SnappedRun& run : runs_) run = with_corner(picker_, run, corner, edge_ / 2);
      current_ = snapped_curve(surface_, picker_, stroke_, runs_, whole, least_share * step);
    }
  }

  /// Moves where a run around a whole closed stroke begins away from a corner.
  void begin_half_a_turn_later(SnappedRun& run) const {
    const auto middle = std::ranges::lower_bound(run, period() / 2, {}, &SnappedPoint::stroke_t);
    for (auto point = run.begin(); point != middle; ++point) point->stroke_t += period();
    std::rotate(run.begin(), middle, run.end());
  }

  double moved(const SnappedPoint& point) const {
    return (point.at.position.cast<double>() - stroke_position(stroke_, point.stroke_t)).norm();
  }

  /// Makes runs of points; the columns go around a closed stroke from one that has none, if there is one.
  void collect_runs(const std::vector<PathColumn>& path,
                    const std::vector<std::optional<SnappedPoint>>& points, bool whole) {
    std::size_t start = 0;
    if (stroke_.closed && !whole)
      start = static_cast<std::size_t>(
          std::ranges::find_if(
              path, [&](const PathColumn& column) { return column.significance < least_significance_; }) -
          path.begin());
    SnappedRun run;
    double sum = 0;
    const auto end_run = [&] {
      const bool is_long =
          !run.empty() && (whole || run.back().stroke_t - run.front().stroke_t >= shortest());
      if (is_long) {
        result_.ranges.push_back(
            {run.front().stroke_t, run.back().stroke_t, sum / static_cast<double>(run.size())});
        runs_.push_back(run);
      }
      run.clear();
      sum = 0;
    };
    for (std::size_t k = 0; k < path.size(); ++k) {
      const std::size_t i = (start + k) % path.size();
      if (path[i].significance < least_significance_) end_run();
      if (!points[i]) continue;
      SnappedPoint point = *points[i];
      if (start + k >= path.size()) point.stroke_t += period();
      if (!run.empty() && point.stroke_t <= run.back().stroke_t) continue;
      run.push_back(point);
      sum += path[i].significance;
    }
    end_run();
  }

  /// The least length of a part that is snapped, object units.
  double shortest() const { return std::min(options_.radius / 2, stroke_.length() / 2); }

  void note(const LevelImage& level, const std::vector<PathColumn>& path) {
    SnapImage image{level, level.grid.margin, {}};
    result_.significance = 0;
    for (const PathColumn& column : path) {
      image.rows.push_back(column.row);
      result_.significance = std::max(result_.significance, column.significance);
    }
    result_.images.push_back(std::move(image));
  }

  /// Sums up what the last iteration did.
  void measure() {
    double length = 0, weighted = 0, move = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const SnapRange& range = result_.ranges[i];
      length += range.to - range.from;
      weighted += (range.to - range.from) * range.significance;
      for (const SnappedPoint& point : runs_[i]) move += moved(point);
      count += runs_[i].size();
    }
    if (count == 0) return;
    result_.mean_move = move / static_cast<double>(count);
    if (length > 0) result_.significance = weighted / length;
    if (stroke_.length() > 0) result_.snapped_share = std::min(length / stroke_.length(), 1.);
  }

  double period() const { return stroke_.closed ? stroke_.length() : 0; }

  const Surface& surface_;
  const Picker& picker_;
  StrokeChartBuilder& builder_;
  RoughCharter& rough_;
  const SurfaceCurve& stroke_;
  const Feature& feature_;
  const SnapOptions& options_;
  double least_significance_ = 0;
  double edge_ = 0;   ///< typical one in reach, object units
  double scale_ = 0;  ///< object units; 0 before the first chart
  SnappedCurve current_;
  std::vector<SnappedRun> runs_;  ///< of the last iteration
  SnapResult result_;
};

bool is_positive(double value) { return std::isfinite(value) && value > 0; }

}  // namespace

struct StrokeSnapper::Work {
  Work(const Surface& on, const Picker& with) : surface(on), picker(with), builder(on), rough(on) {}

  const Surface& surface;
  const Picker& picker;
  StrokeChartBuilder builder;
  RoughCharter rough;
};

StrokeSnapper::StrokeSnapper(const Surface& surface, const Picker& picker) {
  if (surface.is_point_set()) throw ContractError("strokes on point sets cannot be snapped");
  work_ = std::make_unique<Work>(surface, picker);
}
StrokeSnapper::~StrokeSnapper() = default;
StrokeSnapper::StrokeSnapper(StrokeSnapper&&) noexcept = default;
StrokeSnapper& StrokeSnapper::operator=(StrokeSnapper&&) noexcept = default;

SnapResult StrokeSnapper::snap(const SurfaceCurve& stroke, const Feature& feature,
                               const SnapOptions& options) {
  if (stroke.points.empty()) throw ContractError("the stroke to snap has no points");
  if (!is_positive(options.radius) || !(options.scale == 0 || is_positive(options.scale)))
    throw ContractError("radius and scale of snapping must be finite and positive");
  if (options.iterations < 1) throw ContractError("snapping needs at least one iteration");
  if (has_values(feature.kind) && feature.values.size() != work_->surface.vertex_count())
    throw ContractError("a value per vertex is needed to snap to");
  return Snapping(work_->surface, work_->picker, work_->builder, work_->rough, stroke, feature, options)
      .run();
}

}  // namespace burin
