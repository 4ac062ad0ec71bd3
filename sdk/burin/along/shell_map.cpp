// Inverts a chart, with heights. The triangle in which (t, d) lies is found by straight lines between
// its corners; the place in it by a few steps towards where the prism's coordinates, which are right to
// second order, are (t, d). Neighbours agree on the line between them in both.
#include <burin/along/shell_map.h>
#include <burin/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace burin {
namespace {

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The straight map from the weights of the corners 1 and 2 of a triangle to (t, d).
struct Corners {
  Vec2d origin, along_a, along_b;
  double area;

  explicit Corners(const Prism& prism)
      : origin(prism.coordinates_of(0)),
        along_a(prism.coordinates_of(1) - origin),
        along_b(prism.coordinates_of(2) - origin),
        area(cross(along_a, along_b)) {}

  /// The weights of a way in the (t, d) plane.
  Vec2d weights(const Vec2d& way) const { return {cross(way, along_b) / area, cross(along_a, way) / area}; }
};

/// The place in a prism where its coordinates are these: by straight lines where that leads nowhere, as where
/// the corners are of different legs.
Vec2d place_in(const Prism& prism, const Vec2d& coordinates) {
  constexpr int steps = 5;
  const Corners corners(prism);
  const Vec2d straight = corners.weights(coordinates - corners.origin);
  if (prism.parted()) return straight;
  Vec2d place = straight;
  Vec2d miss = coordinates - prism.coordinates(place.x(), place.y());
  double least = miss.norm();
  for (int step = 0; step < steps && least > 0; ++step) {
    const Vec2d next = place + corners.weights(miss);
    miss = coordinates - prism.coordinates(next.x(), next.y());
    const double left = miss.norm();
    if (!(left < least)) return step == 0 ? straight : place;
    place = next;
    least = left;
  }
  return place;
}

BoxGrid grid_over(const std::vector<Prism>& prisms) {
  std::vector<Eigen::AlignedBox2d> boxes(prisms.size());
  for (std::size_t i = 0; i < prisms.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) boxes[i].extend(prisms[i].coordinates_of(corner));
  return BoxGrid(boxes);
}

/// The least and the greatest t where d is 0 in a triangle; nothing if d is not 0 in it.
std::optional<std::pair<double, double>> stretch_on_stroke(const Prism& prism) {
  std::optional<std::pair<double, double>> stretch;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d from = prism.coordinates_of(i), to = prism.coordinates_of((i + 1) % 3);
    if (from.y() * to.y() > 0 || from.y() == to.y()) continue;
    const double t = from.x() + from.y() / (from.y() - to.y()) * (to.x() - from.x());
    stretch =
        stretch ? std::pair(std::min(stretch->first, t), std::max(stretch->second, t)) : std::pair(t, t);
  }
  return stretch;
}

}  // namespace

ShellMap::ShellMap(const SolidGround& ground)
    : length_(ground.chart.length), closed_(ground.chart.closed), prisms_(shell_over(ground)) {
  // Those without an extent in the (t, d) plane hold nothing.
  std::erase_if(prisms_, [](const Prism& prism) { return Corners(prism).area == 0; });
  find_covered();
  if (covered_.empty()) throw Error("the surface has no triangles along the stroke");
  grid_ = grid_over(prisms_);
}

/// On closed strokes once more one turn before, so that nothing is open at the seam.
void ShellMap::find_covered() {
  std::vector<Covered> all;
  for (const Prism& prism : prisms_) {
    const auto stretch = stretch_on_stroke(prism);
    if (!stretch) continue;
    all.push_back({stretch->first, stretch->second, &prism, &prism});
    if (closed_) all.push_back({stretch->first - length_, stretch->second - length_, &prism, &prism});
  }
  std::ranges::stable_sort(all, {}, &Covered::begin);
  const double rounding = 1e-9 * length_;
  for (const Covered& next : all) {
    if (covered_.empty() || next.begin > covered_.back().end + rounding) {
      covered_.push_back(next);
    } else if (next.end > covered_.back().end) {
      covered_.back().end = next.end;
      covered_.back().last = next.last;
    }
  }
}

Vec3d ShellMap::operator()(double t, double d, double h) const {
  if (closed_) t -= length_ * std::floor(t / length_);
  std::optional<Hit> hit = find({t, d});
  if (!hit) hit = last_before(start_of(t), d);
  return hit->prism->point(hit->a, hit->b, h);
}

std::optional<ShellMap::Hit> ShellMap::find(const Vec2d& place) const {
  std::optional<Hit> best;
  look_at(place, best);
  // Triangles across the seam of a closed stroke reach beyond its length.
  if (closed_) look_at({place.x() + length_, place.y()}, best);
  return best;
}

/// Triangles that are not turned over and whose corners are of one leg win over others, then the first wins.
void ShellMap::look_at(const Vec2d& place, std::optional<Hit>& best) const {
  constexpr double edge_width = 1e-9;  // in shares of the triangle's height
  const auto rank = [](const Prism& prism) {
    return (Corners(prism).area < 0 ? 2 : 0) + (prism.parted() ? 1 : 0);
  };
  for (const Index i : grid_.around(place)) {
    const Prism& prism = prisms_[i];
    const Corners corners(prism);
    const Vec2d weights = corners.weights(place - corners.origin);
    if (!(std::min({weights.x(), weights.y(), 1 - weights.x() - weights.y()}) >= -edge_width)) continue;
    if (best && std::pair(rank(*best->prism), best->prism) <= std::pair(rank(prism), &prism)) continue;
    const Vec2d at = place_in(prism, place);
    best = Hit{&prism, at.x(), at.y()};
  }
}

/// The start of the line of constant t to a point that no triangle holds: on the stroke, or at the nearer
/// side of a gap.
ShellMap::Start ShellMap::start_of(double t) const {
  if (const auto hit = find({t, 0})) return {*hit, t};
  const auto at = [](double on, const Prism* prism) {
    const Vec2d place = place_in(*prism, {on, 0});
    return Start{{prism, place.x(), place.y()}, on};
  };
  const auto after = std::ranges::upper_bound(covered_, t, {}, &Covered::begin);
  if (after == covered_.begin()) return at(after->begin, after->first);
  const auto before = std::prev(after);
  if (after == covered_.end() || t - before->end < after->begin - t)
    return at(std::min(t, before->end), before->last);
  return at(after->begin, after->first);
}

/// Where the chart ends on the way from the stroke along a line of constant t.
ShellMap::Hit ShellMap::last_before(const Start& start, double d) const {
  constexpr int halvings = 40;
  Hit last = start.on_stroke;
  double covered = 0, open = 1;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (covered + open) / 2;
    const auto hit = find({start.t, middle * d});
    if (hit) last = *hit;
    (hit ? covered : open) = middle;
  }
  return last;
}

}  // namespace burin
