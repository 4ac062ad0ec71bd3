// The shapes of lines of constant d where t passes an end of the stroke.
#include <burin/chart/upwind_frames.h>

#include <algorithm>
#include <numbers>

namespace burin {
namespace {

/// From this k d on a curve's coordinates fold beside it.
constexpr float most_bend = 0.5F;

}  // namespace

/// Beyond its ends the stroke goes on as a geodesic, so that k and J jump where t passes an end of a curved
/// stroke.
void UpwindFrames::pass_ends() {
  at_end_.fill(false);
  for (std::size_t i = 0; i < most_arms_; ++i) arms_[i].share_at_x = 0.5F;
  if (path_->closed()) return;
  pass_end(0, -1);
  pass_end(path_->length(), 1);
}

void UpwindFrames::pass_end(double end, float outward) {
  Lanes t_end, nearest = Lanes::Constant(-unreached), farthest = -nearest;
  for (std::size_t lane = 0; lane < capacity; ++lane)
    t_end[static_cast<Eigen::Index>(lane)] = static_cast<float>(end - origin_[lane < size_ ? lane : 0]);
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    // However a step turns, it does not go farther.
    constexpr float quarter = std::numbers::pi_v<float> / 2;
    const Lanes before = outward * (arms.t - t_end), reach = quarter * arms.length / arms.stretch;
    nearest = nearest.max(before + reach);
    farthest = farthest.min(before - reach);
  }
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    if (nearest[l] > 0 && farthest[l] < 0) pass_end(l, t_end[l], outward);
  }
}

/// Of the arms those tell k and J that come from the side of the end on which x is in the mean. Where there
/// is none, as near the end itself, they follow from the curvatures of stroke and surface.
void UpwindFrames::pass_end(Eigen::Index lane, float t_end, float outward) {
  const auto own_lane = static_cast<std::size_t>(lane);
  told_.clear();
  float weights = 0, beyond = 0, d = 0, gauss = 0, low = unreached, high = -unreached;
  for (std::size_t i = 0; i < arm_count_[own_lane]; ++i) {
    const Arms& arms = arms_[i];
    told_.push_back(told_by(arms, lane));
    const float w = arms.weight[lane], before = outward * (arms.t[lane] - t_end),
                after = outward * (static_cast<float>(told_[i].t) - t_end);
    if (!(w > 0)) continue;
    weights += w;
    beyond += w * after;
    d += w * told_[i].d;
    gauss += w * arms.gauss[lane];
    low = std::min({low, before, after});
    high = std::max({high, before, after});
  }
  if (low > 0 || high <= 0) return;
  at_end_[own_lane] = true;
  d /= weights;
  gauss /= weights;
  const float of_stroke = beyond > 0 ? 0 : path_->curvature(origin_[own_lane] + static_cast<double>(t_end));
  // On the inside of an end whose centre is near the coordinates fold, and count as straight.
  const float bend = of_stroke * d < most_bend ? of_stroke * d : 0;
  curvature_[lane] = (bend == 0 ? 0 : of_stroke / (1 - bend)) + gauss * d;
  stretch_[lane] = std::max(1 - bend - gauss * d * d / 2, least_stretch);
  float same_side = 0, k = 0, j = 0;
  for (std::size_t i = 0; i < arm_count_[own_lane]; ++i) {
    const float w = arms_[i].weight[lane], before = outward * (arms_[i].t[lane] - t_end),
                after = outward * (static_cast<float>(told_[i].t) - t_end);
    if (!(w > 0)) continue;
    if ((before > 0) != (beyond > 0)) {
      if (before * after < 0) arms_[i].share_at_x[lane] = after / (after - before);
      continue;
    }
    same_side += w;
    k += w * told_[i].curvature;
    j += w * told_[i].stretch;
  }
  if (!(same_side > 0)) return;
  curvature_[lane] = k / same_side;
  stretch_[lane] = j / same_side;
}

}  // namespace burin
