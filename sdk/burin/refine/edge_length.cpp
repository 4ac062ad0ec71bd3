// Lengths by the distance to segments, which a tree of boxes over consecutive ones finds. Beside them a
// search ends with the first segment that allows the least of all, and far from them in O(log segments).
#include <burin/base/segment.h>
#include <burin/refine/edge_length.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t fan = 8;
constexpr double infinite = std::numeric_limits<double>::infinity();

double grown(double edge, double radius, double squared_distance) {
  return edge + EdgeLength::growth * std::max(std::sqrt(squared_distance) - radius, 0.);
}

std::vector<EdgeLength::Around> along(const std::vector<std::vector<Vec3d>>& lines, double radius,
                                      double edge) {
  std::vector<EdgeLength::Around> segments;
  for (const std::vector<Vec3d>& line : lines)
    for (std::size_t i = 0; i < std::max<std::size_t>(line.size(), 2) - 1; ++i)
      segments.push_back({line[i], line[std::min(i + 1, line.size() - 1)], radius, edge});
  return segments;
}

}  // namespace

EdgeLength::EdgeLength(const std::vector<std::vector<Vec3d>>& lines, double radius, double edge)
    : EdgeLength(along(lines, radius, edge)) {}

EdgeLength::EdgeLength(std::vector<Around> segments) : segments_(std::move(segments)) {
  std::size_t below = segments_.size();
  do {
    std::vector<Run> runs((below + fan - 1) / fan, Run{{}, 0, infinite});
    const auto add = [&](std::size_t i, double radius, double edge) {
      runs[i / fan].radius = std::max(runs[i / fan].radius, radius);
      runs[i / fan].edge = std::min(runs[i / fan].edge, edge);
    };
    for (std::size_t i = 0; i < below; ++i) {
      if (levels_.empty()) {
        runs[i / fan].box.extend(segments_[i].from).extend(segments_[i].to);
        add(i, segments_[i].radius, segments_[i].edge);
      } else {
        const Run& run = levels_.back()[i];
        runs[i / fan].box.extend(run.box);
        add(i, run.radius, run.edge);
      }
    }
    below = runs.size();
    levels_.push_back(std::move(runs));
  } while (below > 1);
  edge_ = levels_.back()[0].edge;
}

double EdgeLength::at(const Vec3d& place) const {
  double least = infinite;
  least_below(levels_.size() - 1, 0, place, least);
  return least;
}

/// No more than what any segment of a run says.
double EdgeLength::least_in(const Run& run, const Vec3d& place) const {
  return grown(run.edge, run.radius, run.box.squaredExteriorDistance(place));
}

void EdgeLength::least_below(std::size_t level, std::size_t node, const Vec3d& place, double& least) const {
  const std::size_t first = node * fan;
  if (level == 0) {
    for (std::size_t i = first; i < std::min(first + fan, segments_.size()); ++i) {
      const Around& s = segments_[i];
      const double share = share_on_segment(s.from, s.to, place);
      const double squared = (place - s.from - share * (s.to - s.from)).squaredNorm();
      least = std::min(least, grown(s.edge, s.radius, squared));
    }
    return;
  }
  const std::vector<Run>& runs = levels_[level - 1];
  // The one that promises the least first, since what it holds mostly rules out the others.
  std::size_t best = first;
  std::array<double, fan> promised{};
  const std::size_t end = std::min(first + fan, runs.size());
  for (std::size_t i = first; i < end; ++i) {
    promised[i - first] = least_in(runs[i], place);
    if (promised[i - first] < promised[best - first]) best = i;
  }
  const auto visit = [&](std::size_t i) {
    if (promised[i - first] < least) least_below(level - 1, i, place, least);
  };
  visit(best);
  for (std::size_t i = first; i < end; ++i)
    if (i != best) visit(i);
}

bool EdgeLength::is_exceeded(const Vec3d& from, double at_from, const Vec3d& to, double at_to, double length,
                             double factor) const {
  if (length > factor * std::min(at_from, at_to)) return true;
  const double apart = (to - from).norm();
  // Along the line it falls by no more than `growth`, between places so near to each other by a 16th.
  const double least = std::max(edge_, (at_from + at_to - growth * apart) / 2);
  if (length <= factor * least || apart <= least / 4) return false;
  const Vec3d middle = (from + to) / 2;
  const double at_middle = at(middle);
  return is_exceeded(from, at_from, middle, at_middle, length, factor) ||
         is_exceeded(middle, at_middle, to, at_to, length, factor);
}

}  // namespace burin
