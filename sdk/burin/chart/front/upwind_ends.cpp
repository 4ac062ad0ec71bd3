// Where t comes near an end of the stroke or is beyond it. Round ends have coordinates of their own around
// them, see DistanceRay; where the stroke does not end round it goes on as a geodesic, so that k and J jump
// where t passes an end of a curved stroke.
#include <burin/chart/front/upwind_frames.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace burin {
namespace {

/// From this k d on a curve's coordinates fold beside it.
constexpr float most_bend = 0.5F;

}  // namespace

/// Finds how far the nodes may be beyond the ends, and if any is, the rays of all arms.
void UpwindFrames::find_ends() {
  near_ends_ = false;
  for (std::size_t i = 0; i < most_arms_; ++i) {
    Arms& arms = arms_[i];
    arms.across = arms.u;
    arms.out = arms.v;
    arms.share_at_x = 0.5F;
  }
  at_end_.fill(false);
  if (path_->closed() || order_ == 1) return;
  find_end(ends_[0], 0, -1, path_->round_begin());
  find_end(ends_[1], path_->length(), 1, path_->round_end());
  near_ends_ = ends_[0].most.maxCoeff() > 0 || ends_[1].most.maxCoeff() > 0;
  if (!near_ends_) return;
  for (std::size_t i = 0; i < most_arms_; ++i) find_rays(arms_[i]);
}

void UpwindFrames::find_end(End& end, double t, float outward, bool round) const {
  end.outward = outward;
  end.round = round;
  for (std::size_t lane = 0; lane < capacity; ++lane)
    end.t[static_cast<Eigen::Index>(lane)] = static_cast<float>(t - origin_[lane < size_ ? lane : 0]);
  end.most = -unreached;
  end.least = unreached;
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    // However a step turns, it does not go farther.
    constexpr float quarter = std::numbers::pi_v<float> / 2;
    const Lanes before = outward * (arms.t - end.t), reach = quarter * arms.length / arms.stretch;
    end.most = end.most.max(before + reach);
    end.least = end.least.min(before - reach);
  }
}

void UpwindFrames::find_rays(Arms& arms) const {
  Lanes past = Lanes::Zero();
  if (ends_[0].round) past += (arms.t - ends_[0].t).min(0);
  if (ends_[1].round) past += (arms.t - ends_[1].t).max(0);
  arms.rays = rays_to(past, arms.d);
  const Rays& rays = arms.rays;
  const RayParts<Lanes> parts = in_parts(rays, arms.u, arms.v);
  arms.across = rays.from_end.select(parts.across, arms.u);
  arms.out = rays.from_end.select(parts.out, arms.v);
  // As ray_step() has it.
  const Lanes inverse = arms.stretch.inverse(), bend = bend_across(rays, arms.curvature, inverse);
  const Lanes beside = arms.across * inverse * (1 + arms.curvature * arms.out),
              away = arms.out - bend * arms.across.square() / 2;
  const Lanes t = rays.left * beside + rays.ahead * away;
  arms.told_t = arms.t + t;
  arms.told_d = arms.d + rays.left * away - rays.ahead * beside;
  arms.told_length = ((past + t).square() + arms.told_d.square()).sqrt();
}

/// Of frames so far past a round end, and at d.
UpwindFrames::Rays UpwindFrames::rays_to(const Lanes& past, const Lanes& d) {
  const Lanes squared = past.square() + d.square(), root = squared.sqrt(), inverse = root.inverse();
  Rays rays;
  rays.from_end = past != 0 && squared > std::numeric_limits<float>::min();
  rays.ahead = rays.from_end.select(past * inverse, Lanes::Zero());
  rays.left = rays.from_end.select(d * inverse, Lanes::Ones());
  rays.length = rays.from_end.select(root, Lanes::Zero());
  rays.inverse_length = rays.from_end.select(inverse, Lanes::Zero());
  return rays;
}

/// By which e1 turns on the steps to or from frames around an end; others stay.
void UpwindFrames::turn_with_rays(const Arms& arms, Lanes& angle) const {
  const auto turn = [&](const Rays& rays, const Lanes& curvature, const Lanes& stretch) -> Lanes {
    return turn_across(rays, curvature, Lanes(stretch.inverse())) * in_parts(rays, arms.u, arms.v).across;
  };
  const Lanes at_q = turn(arms.rays, arms.curvature, arms.stretch), at_x = turn(rays_, curvature_, stretch_);
  angle = (arms.rays.from_end || rays_.from_end).select(at_q + arms.share_at_x * (at_x - at_q), angle);
}

/// k and J that arms around an end tell.
void UpwindFrames::find_round_shapes(const Arms& arms, Lanes& curvature, Lanes& stretch) {
  const RoundShape<Lanes> shape =
      farther_out<Lanes>({arms.curvature, arms.stretch}, arms.rays.length, arms.told_length, arms.gauss);
  const auto sound = (shape.stretch > least_stretch).eval();
  stretch = arms.rays.from_end.select(shape.stretch, stretch);
  curvature = arms.rays.from_end.select(sound.select(shape.curvature, Lanes::Zero()), curvature);
}

/// What steps of frames around an end add to t and d, to first order; those of others stay.
void UpwindFrames::go_along_rays(const Rays& rays, const Lanes& inverse_stretch, const Lanes& u,
                                 const Lanes& v, Lanes& t, Lanes& d) {
  const auto [across, away] = in_parts(rays, u, v);
  const Lanes beside = across * inverse_stretch;
  t = rays.from_end.select(rays.left * beside + rays.ahead * away, t);
  d = rays.from_end.select(rays.left * away - rays.ahead * beside, d);
}

void UpwindFrames::pass_ends() {
  if (!near_ends_) return;
  past_ = 0;
  past_d_ = 0;
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    weights += arms.weight;
    t += arms.weight * arms.told_t;
    d += arms.weight * arms.told_d;
  }
  const Lanes inverse = weights.inverse();
  for (const End& end : ends_) pass_end(end, t * inverse, d * inverse);
  rays_ = rays_to(past_, past_d_);
}

/// `t`, `d`: where the arms place the nodes that all of them know to be beyond the end.
void UpwindFrames::pass_end(const End& end, const Lanes& t, const Lanes& d) {
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    if (!(end.most[l] > 0)) continue;
    if (end.least[l] < 0)
      pass_end(end, l);
    else
      place_beyond(end, l, t[l] - end.t[l], d[l]);
  }
}

void UpwindFrames::place_beyond(const End& end, Eigen::Index lane, float past, float d) {
  if (!end.round) return;
  past_[lane] = past;
  past_d_[lane] = d;
}

/// Of the arms those tell k and J that come from the side of the end on which x is in the mean. Where there
/// is none, as near the end itself, they follow from the curvatures of stroke and surface.
void UpwindFrames::pass_end(const End& end, Eigen::Index lane) {
  const auto own_lane = static_cast<std::size_t>(lane);
  const float t_end = end.t[lane], outward = end.outward;
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
  beyond /= weights;
  d /= weights;
  gauss /= weights;
  if (high <= 0) return;
  // Where it is beyond the other end of a short stroke that one tells.
  if (!(beyond > 0) && past_[lane] != 0) return;
  if (beyond > 0) place_beyond(end, lane, outward * beyond, d);
  if (low > 0) return;
  at_end_[own_lane] = true;
  shape_at_end(end, lane, beyond, d, gauss);
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

/// k and J of a node so far beyond the end, or beside the stroke, that follow from what is known there.
void UpwindFrames::shape_at_end(const End& end, Eigen::Index lane, float beyond, float d, float gauss) {
  if (beyond > 0 && end.round) {
    const auto [curvature, stretch] = shape_around_end(std::sqrt(beyond * beyond + d * d), gauss);
    curvature_[lane] = stretch > least_stretch ? curvature : 0;
    stretch_[lane] = std::max(stretch, least_stretch);
    return;
  }
  const double t_end = origin_[static_cast<std::size_t>(lane)] + static_cast<double>(end.t[lane]);
  const float of_stroke = beyond > 0 ? 0 : path_->curvature(t_end);
  // On the inside of an end whose centre is near the coordinates fold, and count as straight.
  const float bend = of_stroke * d < most_bend ? of_stroke * d : 0;
  curvature_[lane] = (bend == 0 ? 0 : of_stroke / (1 - bend)) + gauss * d;
  stretch_[lane] = std::max(1 - bend - gauss * d * d / 2, least_stretch);
}

}  // namespace burin
