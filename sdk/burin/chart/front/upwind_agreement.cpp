// Which arms of a node tell its frame: where parts of the stroke meet, the one that places it nearest to the
// stroke and those that agree with it.
#include <burin/chart/front/leader.h>
#include <burin/chart/front/upwind_frames.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Arms that agree count about half that place x as far from where the nearest does, in lengths of both, and
/// at least so much.
constexpr float doubtful_apart_in_d = 0.05F, least_count = 0.5F;

/// Arms agree that place x this near to each other: t and d, in lengths of the arms. Arms of other directions
/// (1 - cosine) agree in d only as far as they do by chance.
constexpr float apart_in_t = 2, apart_in_d = 0.5F, least_apart_in_d = 0.02F, other_direction = 0.3F;

}  // namespace

void UpwindFrames::keep_agreeing() {
  left_out_.fill(false);
  focal_.fill(false);
  const auto placed_t = [this](const Arms& arms) {
    const Lanes t = arms.t + arms.u;
    return near_ends_ ? Lanes(arms.rays.from_end.select(arms.told_t, t)) : t;
  };
  const auto placed_d = [this](const Arms& arms) {
    const Lanes &u = arms.u, &v = arms.v, &k = arms.curvature;
    const Lanes size = ((k * u).square() + (1 - k * v).square()).sqrt();
    const Lanes d = arms.d + (2 * v - k * (u.square() + v.square())) / (1 + size);
    return near_ends_ ? Lanes(arms.rays.from_end.select(arms.told_d, d)) : d;
  };
  Lanes t_low = placed_t(arms_[0]), t_high = t_low, d_low = placed_d(arms_[0]), d_high = d_low,
        shortest = arms_[0].length;
  for (std::size_t i = 1; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    const Lanes t = placed_t(arms), d = placed_d(arms);
    t_low = t_low.min(t);
    t_high = t_high.max(t);
    d_low = d_low.min(d);
    d_high = d_high.max(d);
    shortest = shortest.min(arms.length);
  }
  // Where no two are farther apart than the shortest edges allow there is nothing to choose from.
  const Lanes apart =
      (t_high - t_low - apart_in_t * shortest).max(d_high - d_low - least_apart_in_d * shortest);
  if (apart.maxCoeff() <= 0) return;
  for (std::size_t lane = 0; lane < size_; ++lane)
    if (!(apart[static_cast<Eigen::Index>(lane)] <= 0)) keep_agreeing(static_cast<Eigen::Index>(lane));
}

void UpwindFrames::keep_agreeing(Eigen::Index lane) {
  const std::size_t count = arm_count_[static_cast<std::size_t>(lane)];
  std::vector<ChartFrame>& told = told_;
  told.clear();
  float least = unreached;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    told.push_back(told_by(arms_[i], lane));
    const double t = origin_[static_cast<std::size_t>(lane)] + told[i].t;
    const auto at =
        static_cast<float>(path_->distance(t, static_cast<double>(told[i].d), position_.get(lane)));
    const float distance =
        distance_along(arms_[i].g[lane], arms_[i].shortfall[lane], arms_[i].length[lane], at);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float reach = arms_[i].length[lane] + arms_[nearest].length[lane];
    const float otherwise = (1 - told[i].e1.dot(told[nearest].e1)) / other_direction;
    const float in_d = std::max(apart_in_d * (1 - otherwise), least_apart_in_d) / 2;
    const auto t = static_cast<float>(std::abs(told[i].t - told[nearest].t));
    const float d = std::abs(told[i].d - told[nearest].d);
    if (t <= apart_in_t * reach && d <= in_d * reach) {
      const float doubts = d / (doubtful_apart_in_d * reach);
      // Where the surface is rough their differences are chance, and the mean of all is nearer to the truth.
      arms_[i].counts[lane] = least_count + (1 - least_count) / (1 + doubts * doubts);
      continue;
    }
    leave_out(i, lane);
    left_out_[static_cast<std::size_t>(lane)] = true;
  }
  // Repeats of an arm that is left out have no say in what is near a focal point either.
  for (std::size_t i = count; i < most_arms_; ++i) leave_out(i, lane);
}

void UpwindFrames::leave_out(std::size_t arm, Eigen::Index lane) {
  Arms& arms = arms_[arm];
  arms.counts[lane] = arms.curvature[lane] = arms.gauss[lane] = 0;
  arms.stretch[lane] = 1;
}

}  // namespace burin
