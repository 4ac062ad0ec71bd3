// Lengths by the distance to lines, which a tree of boxes over consecutive segments finds. Beside the lines a
// search ends with the first segment that is near enough, and far from them in O(log segments).
#include <burin/base/segment.h>
#include <burin/refine/edge_length.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t fan = 8;

double squared_distance(const Vec3d& from, const Vec3d& to, const Vec3d& place) {
  return (place - from - share_on_segment(from, to, place) * (to - from)).squaredNorm();
}

}  // namespace

EdgeLength::EdgeLength(const std::vector<std::vector<Vec3d>>& lines, double radius, double edge)
    : radius_(radius), edge_(edge) {
  for (const std::vector<Vec3d>& line : lines)
    for (std::size_t i = 0; i < std::max<std::size_t>(line.size(), 2) - 1; ++i)
      segments_.push_back({line[i], line[std::min(i + 1, line.size() - 1)]});
  std::size_t below = segments_.size();
  do {
    std::vector<Box> boxes((below + fan - 1) / fan);
    for (std::size_t i = 0; i < below; ++i)
      if (levels_.empty())
        boxes[i / fan].extend(segments_[i].from).extend(segments_[i].to);
      else
        boxes[i / fan].extend(levels_.back()[i]);
    below = boxes.size();
    levels_.push_back(std::move(boxes));
  } while (below > 1);
}

double EdgeLength::at(const Vec3d& place) const {
  return edge_ + growth * std::max(distance(place) - radius_, 0.);
}

/// At most the radius where it is less.
double EdgeLength::distance(const Vec3d& place) const {
  double squared = std::numeric_limits<double>::infinity();
  nearest_below(levels_.size() - 1, 0, place, squared);
  return std::sqrt(squared);
}

void EdgeLength::nearest_below(std::size_t level, std::size_t node, const Vec3d& place,
                               double& squared) const {
  const std::size_t first = node * fan;
  if (level == 0) {
    for (std::size_t i = first; i < std::min(first + fan, segments_.size()); ++i)
      squared = std::min(squared, squared_distance(segments_[i].from, segments_[i].to, place));
    return;
  }
  const std::vector<Box>& boxes = levels_[level - 1];
  // The nearest box first, since what it holds mostly rules out the others.
  std::size_t nearest = first;
  std::array<double, fan> apart{};
  const std::size_t end = std::min(first + fan, boxes.size());
  for (std::size_t i = first; i < end; ++i) {
    apart[i - first] = boxes[i].squaredExteriorDistance(place);
    if (apart[i - first] < apart[nearest - first]) nearest = i;
  }
  const auto visit = [&](std::size_t i) {
    if (squared > radius_ * radius_ && apart[i - first] < squared)
      nearest_below(level - 1, i, place, squared);
  };
  visit(nearest);
  for (std::size_t i = first; i < end; ++i)
    if (i != nearest) visit(i);
}

bool EdgeLength::is_exceeded(const Vec3d& from, double at_from, const Vec3d& to, double at_to, double length,
                             double factor) const {
  if (length > factor * std::min(at_from, at_to)) return true;
  const double apart = (to - from).norm();
  // Along the line it falls by no more than `growth`.
  const double least = std::max(edge_, (at_from + at_to - growth * apart) / 2);
  if (length <= factor * least || apart <= edge_ / 4) return false;
  const Vec3d middle = (from + to) / 2;
  const double at_middle = at(middle);
  return is_exceeded(from, at_from, middle, at_middle, length, factor) ||
         is_exceeded(middle, at_middle, to, at_to, length, factor);
}

double EdgeLength::area() const {
  double length = 0;
  for (const Segment& segment : segments_) length += (segment.to - segment.from).norm();
  return radius_ * (2 * length + std::numbers::pi * radius_);
}

}  // namespace burin
