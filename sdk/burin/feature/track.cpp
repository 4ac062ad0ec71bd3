// Follows lines by snapping the line before: what was found and did not jump is followed further. Costs
// O(points) beside the snap.
#include <burin/base/error.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/feature/snapped_curve.h>
#include <burin/feature/track.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// A place on a curve: a share of a segment.
struct Place {
  std::size_t segment = 0;
  double share = 0;
  double turns = 0;  ///< around a closed curve
};

Place place_at(const SurfaceCurve& curve, double t) {
  Place place;
  if (curve.closed) place.turns = std::floor(t / curve.length());
  const double within = t - place.turns * (curve.closed ? curve.length() : 0);
  place.segment = segment_at(curve, within);
  const double begin = curve.points[place.segment].t, length = curve.segment_end(place.segment) - begin;
  if (length > 0) place.share = std::clamp((within - begin) / length, 0., 1.);
  return place;
}

/// The arc length of a place on the curve.
double t_at(const SurfaceCurve& curve, const Place& place) {
  const double begin = curve.points[place.segment].t;
  return begin + place.share * (curve.segment_end(place.segment) - begin) + place.turns * curve.length();
}

double start_t_at(const TrackedLine& line, const Place& place) {
  const std::size_t next = line.curve.next(place.segment);
  const double from = line.start_t[place.segment],
               to = line.start_t[next] + (next < place.segment ? line.start_length : 0);
  return from + place.share * (to - from) + place.turns * line.start_length;
}

/// The line on the surface as it is now, with as many points; nothing if a point is farther than `farthest`
/// from it.
std::optional<SurfaceCurve> carried(const Surface& surface, const Picker& picker, const SurfaceCurve& curve,
                                    double farthest) {
  SnappedRun run;
  for (const CurvePoint& point : curve.points) {
    SurfacePoint at = point.at;
    const bool in_place =
        at.triangle < surface.triangles.size() && surface.triangles[at.triangle] == at.corners;
    if (in_place) {
      at.position = Vec3f::Zero();
      for (std::size_t i = 0; i < 3; ++i) at.position += at.weights[i] * surface.positions[at.corners[i]];
    } else {
      const auto closest = picker.closest(at.position, static_cast<float>(farthest));
      if (!closest) return std::nullopt;
      at = *closest;
    }
    run.push_back({point.t, at});
  }
  constexpr double all_points = -1;
  return snapped_curve(surface, picker, curve, {run}, true, all_points).curve;
}

/// What became of a point of a line.
enum class Fate { followed, lost, jumped };

/// A point of the line as it is now.
struct FollowedPoint {
  CurvePoint point;
  double t = 0;      ///< arc length on the carried line; on closed ones it may be beyond the length
  double moved = 0;  ///< from there, object units
  Fate fate = Fate::followed;
};

bool is_followed(const FollowedPoint& point) { return point.fate == Fate::followed; }

/// Points [begin, end) with one answer to whether they are followed.
struct FateRun {
  std::size_t begin, end;
  bool followed;
};

std::vector<FateRun> runs_of(const std::vector<FollowedPoint>& points) {
  std::vector<FateRun> runs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool followed = is_followed(points[i]);
    if (runs.empty() || runs.back().followed != followed) runs.push_back({i, i, followed});
    runs.back().end = i + 1;
  }
  return runs;
}

/// The points of a snapped line and their fates. Those of a closed line that opens start where it is lost.
std::vector<FollowedPoint> points_of(const SurfaceCurve& carried, const SnapResult& snapped,
                                     double most_moved) {
  const double period = carried.closed ? carried.length() : 0;
  const auto found = [&](double t) {
    return std::ranges::any_of(snapped.ranges, [&](const SnapRange& range) {
      return (t >= range.from && t <= range.to) || (period > 0 && t + period <= range.to);
    });
  };
  std::vector<FollowedPoint> points;
  for (std::size_t i = 0; i < snapped.curve.points.size(); ++i) {
    const CurvePoint& point = snapped.curve.points[i];
    const double t = snapped.stroke_t[i];
    const double moved = (point.at.position.cast<double>() - stroke_position(carried, t)).norm();
    const Fate fate = !found(t) ? Fate::lost : moved > most_moved ? Fate::jumped : Fate::followed;
    points.push_back({point, t, moved, fate});
  }
  const auto first_lost = std::ranges::find_if_not(points, is_followed);
  if (!carried.closed || first_lost == points.end()) return points;
  const double duration = points.back().point.time - points.front().point.time;
  std::for_each(points.begin(), first_lost, [&](FollowedPoint& point) {
    point.t += period;
    point.point.t += snapped.curve.length();
    point.point.time += duration;
  });
  std::rotate(points.begin(), first_lost, points.end());
  return points;
}

/// Parts that are too short to be followed are lost.
void drop_short(std::vector<FollowedPoint>& points, double shortest) {
  for (const FateRun& run : runs_of(points))
    if (run.followed && points[run.end - 1].t - points[run.begin].t < shortest)
      for (std::size_t i = run.begin; i < run.end; ++i) points[i].fate = Fate::lost;
}

/// The points of a run as a line of its own.
TrackedLine line_of(const TrackedLine& before, const SurfaceCurve& carried,
                    std::span<const FollowedPoint> points) {
  TrackedLine line{{}, {}, before.start_length};
  for (const FollowedPoint& point : points) {
    line.curve.points.push_back(point.point);
    line.curve.points.back().t -= points.front().point.t;
    line.start_t.push_back(start_t_at(before, place_at(carried, point.t)));
  }
  return line;
}

Loss loss_of(const TrackedLine& before, const SurfaceCurve& carried, std::span<const FollowedPoint> points,
             bool at_end) {
  Loss loss{at_end && !carried.closed ? LossKind::ended : LossKind::split,
            t_at(before.curve, place_at(carried, points.front().t)),
            t_at(before.curve, place_at(carried, points.back().t))};
  if (std::ranges::find(points, Fate::jumped, &FollowedPoint::fate) != points.end())
    loss.kind = LossKind::jumped;
  return loss;
}

bool is_usable(const TrackedLine& line, const TrackOptions& options) {
  return options.most_edges > 0 && line.start_t.size() == line.curve.points.size();
}

}  // namespace

LineTracker::LineTracker(const Surface& surface, const Picker& picker)
    : surface_(surface), picker_(picker), snapper_(surface, picker) {}

TrackStep LineTracker::follow(const TrackedLine& before, const Feature& feature,
                              const TrackOptions& options) {
  if (!is_usable(before, options)) throw ContractError("a line cannot be followed like that");
  TrackStep step;
  const auto line = carried(surface_, picker_, before.curve, options.snap.radius);
  if (!line) {
    step.losses.push_back({LossKind::ended, 0, before.curve.length()});
    return step;
  }
  SnapOptions how = options.snap;
  how.is_near = true;
  step.snapped = snapper_.snap(*line, feature, how);
  auto points = points_of(*line, step.snapped, options.most_edges * step.snapped.edge);
  const bool whole = std::ranges::all_of(points, is_followed);
  if (!whole) drop_short(points, std::min(how.radius, line->length()) / 2);
  for (const FateRun& run : runs_of(points)) {
    const auto part = std::span(points).subspan(run.begin, run.end - run.begin);
    if (run.followed)
      step.lines.push_back(line_of(before, *line, part));
    else
      step.losses.push_back(loss_of(before, *line, part, run.begin == 0 || run.end == points.size()));
  }
  if (whole && line->closed) {
    step.lines.front().curve.closed = true;
    step.lines.front().curve.closing_length = step.snapped.curve.closing_length;
  }
  for (const FollowedPoint& point : points)
    if (is_followed(point)) step.most_moved = std::max(step.most_moved, point.moved);
  return step;
}

TrackedLine tracked(const SurfaceCurve& curve) {
  TrackedLine line{curve, {}, curve.closed ? curve.length() : 0};
  for (const CurvePoint& point : curve.points) line.start_t.push_back(point.t);
  return line;
}

}  // namespace burin
