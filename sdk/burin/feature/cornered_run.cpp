// Puts the legs of corners into runs. O(n) for n points, with one closest point per new one.
#include <burin/feature/cornered_run.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

/// Points of a leg from where a run's point `end` is nearest to it up to the corner, which is left out. The
/// run's offset from the leg fades.
std::vector<Vec3d> along(const Leg& leg, const Vec3d& end, double step) {
  const double from = leg.nearest(end), way = from - leg.to_corner;
  const Vec3d offset = end - leg.position(from);
  const int count = std::max(1, static_cast<int>(std::ceil(way / step)));
  std::vector<Vec3d> points;
  for (int i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / count, left = std::max(1 - 2 * share, 0.);
    points.push_back(leg.position(from - share * way) + left * left * (3 - 2 * left) * offset);
  }
  return points;
}

}  // namespace

SnappedRun with_corner(const Picker& picker, const SnappedRun& run, const RunCorner& at, double step) {
  const auto first = std::ranges::lower_bound(run, at.from, {}, &SnappedPoint::stroke_t);
  const auto last = std::ranges::upper_bound(run, at.to, {}, &SnappedPoint::stroke_t);
  if (first == run.begin() || last == run.end()) return run;
  const SnappedPoint &before = *std::prev(first), &after = *last;
  std::vector<Vec3d> way = along(at.corner.before, before.at.position.cast<double>(), step);
  std::vector<Vec3d> back = along(at.corner.after, after.at.position.cast<double>(), step);
  way.push_back(at.corner.position);
  way.insert(way.end(), back.rbegin(), back.rend());
  SnappedRun result(run.begin(), first);
  for (std::size_t i = 0; i < way.size(); ++i) {
    const auto point = picker.closest(way[i].cast<float>(), static_cast<float>(step));
    if (!point) return run;
    const double share = (static_cast<double>(i) + 1) / (static_cast<double>(way.size()) + 1);
    result.push_back({before.stroke_t + share * (after.stroke_t - before.stroke_t), *point});
  }
  result.insert(result.end(), last, run.end());
  return result;
}

}  // namespace burin
