// Cuts a stroke at its bends into legs. Costs what finding the bends costs, and O(b log n) for b bends of a
// curve of n points.
#include <burin/chart/joins/stroke_legs.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// A bend shorter than this share of the radius is a corner.
constexpr double corner_length = 0.5;

/// The arc length below which two lists of bends have the same influence on joins, on a curve that is the
/// same below `unchanged_t`: bends choose between nodes up to `near` before them, and spread t over their
/// span, by how the stroke turns there.
double same_below(std::span<const SpreadBend> before, std::span<const SpreadBend> now, double near,
                  double unchanged_t) {
  double below = unchanged_t;
  const auto limit = [&](const SpreadBend& bend) {
    below = std::min(below, bend.bend.begin - std::max(near, bend.span));
  };
  const auto [old_end, new_end] = std::ranges::mismatch(before, now);
  std::for_each(old_end, before.end(), limit);
  std::for_each(new_end, now.end(), limit);
  const auto first_open = std::ranges::find_if(
      now, [&](const SpreadBend& bend) { return bend.bend.middle + bend.span >= unchanged_t; });
  std::for_each(first_open, now.end(), limit);
  return below;
}

}  // namespace

double StrokeLegs::update(const SurfaceCurve& curve, std::size_t unchanged) {
  const bool was_closed = std::exchange(closed_, curve.closed);
  length_ = curve.length();
  const std::vector<SpreadBend> old_cuts = std::exchange(cuts_, {}), old_uncut = std::exchange(uncut_, {});
  corners_.clear();
  if (options_.join != Join::round) {
    bends_.update(curve, options_.radius, unchanged);
    find_cuts(curve);
  }
  legs_.clear();
  ends_.clear();
  if (cuts_.empty()) {
    add_leg(0, length_);
  } else {
    if (!closed_) add_leg(0, cuts_.front().bend.begin);
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) add_leg(cuts_[i].bend.end, cuts_[i + 1].bend.begin);
    add_leg(cuts_.back().bend.end, closed_ ? cuts_.front().bend.begin + length_ : length_);
  }
  if (closed_ || was_closed || unchanged == 0) return -std::numeric_limits<double>::infinity();
  const double near = corner_nearness * options_.radius, unchanged_t = curve.points[unchanged - 1].t;
  return std::min(same_below(old_cuts, cuts_, near, unchanged_t),
                  same_below(old_uncut, uncut_, near, unchanged_t));
}

bool StrokeLegs::is_corner(const Bend& bend) const {
  return bend.end - bend.begin < corner_length * options_.radius;
}

bool StrokeLegs::is_cut(const Bend& bend) const {
  if (options_.join != Join::overlap && !is_corner(bend)) return false;
  if (options_.join == Join::miter && !(miter_reach(bend.turn, options_.radius) > 0)) return false;
  return closed_ || (bend.begin > 0 && bend.end < length_);
}

void StrokeLegs::find_cuts(const SurfaceCurve& curve) {
  const std::span<const Bend> bends = bends_.all();
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const SpreadBend spread{bends[i], span(i)};
    if (is_cut(bends[i])) {
      // The first corner of a closed stroke ends the last leg, which counts t on beyond the length.
      corners_.push_back(corner_at(curve, spread, closed_ && cuts_.empty() ? length_ : 0));
      cuts_.push_back(spread);
    } else {
      uncut_.push_back(spread);
    }
  }
}

Corner StrokeLegs::corner_at(const SurfaceCurve& curve, const SpreadBend& cut, double loop) const {
  const auto [begin, middle, end, turn] = cut.bend;
  const Vec3d from = point_at(curve, begin).at.position.cast<double>();
  const double chord = (point_at(curve, end).at.position.cast<double>() - from).norm();
  const double way = std::min(chord / 2 / math::cos(bounded_half(turn)), options_.radius);
  return {.first = begin + way + loop,
          .second = end - way,
          .first_past = begin + way - middle,
          .second_past = middle - (end - way),
          .turn = turn,
          .span = cut.span};
}

/// How far before and after a bend a smooth join spreads t: long enough that |grad t| stays between 1/2 and 2
/// at a right angle, but at most half way to the next bend, and not beyond an end of the stroke.
double StrokeLegs::span(std::size_t bend) const {
  const std::span<const Bend> all = bends_.all();
  const double middle = all[bend].middle;
  double span = 4 * options_.radius * math::tan(bounded_half(all[bend].turn));
  span = closed_ ? std::min(span, length_ / 2) : std::min({span, middle, length_ - middle});
  const auto keep_off = [&](double other) { span = std::min(span, std::abs(other - middle) / 2); };
  if (bend > 0) keep_off(all[bend - 1].middle);
  if (bend + 1 < all.size()) keep_off(all[bend + 1].middle);
  if (closed_ && all.size() > 1 && bend == 0) keep_off(all.back().middle - length_);
  if (closed_ && all.size() > 1 && bend + 1 == all.size()) keep_off(all.front().middle + length_);
  return span;
}

std::span<const SpreadBend> StrokeLegs::uncut_around(double t) const {
  if (closed_) return uncut_;
  const auto end = [](const SpreadBend& bend) { return bend.bend.middle + bend.span; };
  const auto at = std::ranges::lower_bound(uncut_, t, {}, end);
  return at == uncut_.end() ? std::span<const SpreadBend>() : std::span(at, 1);
}

/// How far a leg continues beyond an end at a corner of this turn, object units.
double StrokeLegs::reach(double turn) const {
  const double beyond = options_.join == Join::miter    ? miter_reach(turn, charted_radius_)
                        : options_.join == Join::smooth ? smooth_reach(turn, charted_radius_)
                                                        : 0;
  return beyond > 0 ? 1.1 * beyond + corner_length * charted_radius_ : 0;
}

/// The corners at both ends of a leg. On a closed stroke each leg begins at the corner of its own number.
LegEnds StrokeLegs::ends_of(std::size_t leg) const {
  LegEnds ends;
  const std::size_t corners = corners_.size(), legs = corners + (closed_ ? 0 : 1);
  const auto end = [&](std::size_t cut, bool first_leg) {
    const std::size_t other = first_leg ? (leg + 1) % legs : (leg + legs - 1) % legs;
    return LegEnd{corners_[cut], static_cast<Index>(cut), first_leg, static_cast<Index>(other),
                  reach(corners_[cut].turn) > 0};
  };
  if (corners == 0) return ends;
  if (closed_ || leg > 0) ends.before = end(closed_ ? leg : leg - 1, false);
  if (closed_ || leg < corners) ends.after = end(closed_ ? (leg + 1) % corners : leg, true);
  return ends;
}

void StrokeLegs::add_leg(double begin, double end) {
  const LegEnds ends = ends_of(legs_.size());
  const auto reach_at = [&](const std::optional<LegEnd>& at) { return at ? reach(at->corner.turn) : 0; };
  legs_.push_back({begin, std::max(begin, end), {reach_at(ends.before), reach_at(ends.after)}});
  ends_.push_back(ends);
}

}  // namespace burin
