// Runs a state machine with the states "moving" and "resting". Samples wait until it is known whether they
// become knots. A call costs O(waiting samples + log knots).
#include <burin/stroke/curve/pen_path.h>

#include <algorithm>

namespace burin {
namespace {

double distance(const PenKnot& a, const PenKnot& b) {
  return (b.position() - a.position()).cast<double>().norm();
}

bool same_pen(const Pen& a, const Pen& b) {
  return a.pressure == b.pressure && a.tilt_x == b.tilt_x && a.tilt_y == b.tilt_y && a.twist == b.twist;
}

}  // namespace

PenPath::PenPath(double radius, double least_step)
    : least_step_(least_step), zone_(std::max(radius / 20, 2 * least_step)) {}

PenPath::Change PenPath::add(std::vector<PenKnot>& knots, const PenKnot& sample) {
  if (knots.empty()) {
    knots.push_back(sample);
    taken_ = 1;
    return Change::path;
  }
  if (knots.back().position() == sample.position()) {
    knots.back().time = sample.time;
    knots.back().pen = sample.pen;
    if (knots.size() > taken_) waiting_[knots.size() - taken_ - 1] = knots.back();
    return Change::pen;
  }
  const std::size_t count = knots.size();
  const PenKnot last = knots.back();
  knots.resize(taken_);
  wait(knots.back(), sample);
  if (resting_)
    rest(knots);
  else
    go_on(knots);
  show(knots);
  const bool other_pen = !same_pen(last.pen, sample.pen);
  knots.back().pen = sample.pen;
  if (knots.size() != count || knots.back().position() != last.position()) return Change::path;
  return other_pen ? Change::pen : Change::none;
}

/// Appends a sample to the waiting ones. It replaces the last one if that is nearer than the least step to
/// the one before it, or while the pen trembles.
void PenPath::wait(const PenKnot& anchor, const PenKnot& sample) {
  const auto before_last = [&]() -> const PenKnot& {
    return waiting_.size() > 1 ? waiting_[waiting_.size() - 2] : anchor;
  };
  if (!waiting_.empty() && (trembles_ || distance(before_last(), waiting_.back()) < least_step_))
    waiting_.pop_back();
  const PenKnot& before = waiting_.empty() ? anchor : waiting_.back();
  PenKnot next = sample;
  next.path_length = before.path_length + distance(before, sample);
  waiting_.push_back(next);
}

void PenPath::go_on(std::vector<PenKnot>& knots) {
  if (distance(knots.back(), waiting_.back()) < least_step_) return;
  resting_ = turns_back(knots);
  if (resting_)
    rest(knots);
  else
    take_waiting(knots);
}

void PenPath::rest(std::vector<PenKnot>& knots) {
  constexpr double straying = 1.5;  // path length over distance from where the pen rests
  const PenKnot& anchor = knots.back();
  const double away = distance(anchor, waiting_.back());
  farthest_ = std::max(farthest_, away);
  if (away > zone_) return take_waiting(knots);
  if (trembles_ || waiting_.back().path_length - anchor.path_length <= straying * farthest_) return;
  trembles_ = true;
  waiting_ = {waiting_.back()};
}

void PenPath::take_waiting(std::vector<PenKnot>& knots) {
  knots.insert(knots.end(), waiting_.begin(), waiting_.end());
  taken_ = knots.size();
  waiting_.clear();
  trembles_ = false;
  farthest_ = 0;
  resting_ = makes_no_progress(knots);
}

void PenPath::show(std::vector<PenKnot>& knots) const {
  if (trembles_) return;
  for (const PenKnot& sample : waiting_)
    if (distance(knots.back(), sample) >= least_step_) knots.push_back(sample);
}

bool PenPath::turns_back(const std::vector<PenKnot>& knots) const {
  if (knots.size() < 2) return false;
  const Vec3f &before = knots[knots.size() - 2].position(), &last = knots.back().position();
  return (last - before).dot(waiting_.back().position() - last) < 0;
}

bool PenPath::makes_no_progress(const std::vector<PenKnot>& knots) const {
  const PenKnot& last = knots.back();
  const auto after = std::ranges::upper_bound(knots, last.path_length - 2 * zone_, {}, &PenKnot::path_length);
  if (after == knots.begin()) return false;
  const PenKnot& first = *(after - 1);
  return distance(first, last) < (last.path_length - first.path_length) / 2;
}

}  // namespace burin
