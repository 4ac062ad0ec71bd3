// Second order. In Fermi coordinates (t, d) along the stroke, with k the geodesic curvature of the lines of
// constant d, J the stretch of t and K the Gauss curvature, a step of the vector (u, v) from q to x changes
//   k by K v + k^2 v,  J by -J (k v + K v^2 / 2),  the angle of e1 by k u,  t by u / J,  d by v
// per unit of length; beyond round ends to the like around these. k and J come first, from q alone; they vary
// along t as well, which q cannot know, so the mean over the arms is taken where the line through their
// values over u has u = 0. Then e1, t and d are integrated by the trapezoidal rule between the frames of q
// and x, which needs no derivative of k or J.
//
// Around corners, where k is beyond that, lines of constant d are circles, and each arm tells the frame at x
// by itself. Where parts of the stroke meet, the arm holds that places x nearest to the stroke, and those
// that agree with it.
#include <burin/chart/frames/frame_step.h>
#include <burin/chart/frames/propagate_frame.h>
#include <burin/chart/front/leader.h>
#include <burin/chart/front/upwind_frames.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Beyond this turn along one step a corner or a focal point is near, radians.
constexpr float largest_turn = 0.5F;

template <class A, class B>
auto dot(const A& a, const B& b) {
  return (a.x * b.x + a.y * b.y + a.z * b.z).eval();
}

template <class A, class B>
A cross(const A& a, const B& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

void UpwindFrames::add_node(const FrontNode& x) {
  const auto lane = static_cast<Eigen::Index>(size_);
  if (size_ == 0) most_arms_ = 0;
  arm_count_[size_++] = 0;
  position_.set(lane, x.position);
  normal_.set(lane, x.normal);
  gauss_[lane] = x.gauss;
}

void UpwindFrames::add_arm(const FrontNode& q, double t) {
  const std::size_t node = size_ - 1, arm = arm_count_[node]++;
  const auto lane = static_cast<Eigen::Index>(node);
  if (arm == 0) origin_[node] = t;
  most_arms_ = std::max(most_arms_, arm + 1);
  if (arms_.size() < most_arms_) arms_.resize(most_arms_);
  Arms& arms = arms_[arm];
  arms.normal.set(lane, q.normal);
  arms.e1.set(lane, q.frame.e1);
  arms.chord.set(lane, position_.get(lane) - q.position);
  arms.t[lane] = static_cast<float>(t - origin_[node]);
  arms.d[lane] = q.frame.d;
  arms.curvature[lane] = q.frame.curvature;
  arms.stretch[lane] = q.frame.stretch;
  arms.gauss[lane] = (gauss_[lane] + q.gauss) / 2;
  arms.g[lane] = q.g();
  arms.shortfall[lane] = shortfall_of(q, *path_);
  arms.counts[lane] = 1;
}

/// Repeats nodes in lanes, and arms in nodes, that there are too few of. Repeated arms do not count.
void UpwindFrames::fill_up() {
  const auto repeat = [this](std::size_t to_arm, std::size_t to, std::size_t from_arm, std::size_t from) {
    Arms& target = arms_[to_arm];
    const Arms& source = arms_[from_arm];
    const auto t = static_cast<Eigen::Index>(to), f = static_cast<Eigen::Index>(from);
    target.normal.set(t, source.normal.get(f));
    target.e1.set(t, source.e1.get(f));
    target.chord.set(t, source.chord.get(f));
    target.t[t] = source.t[f];
    target.d[t] = source.d[f];
    target.curvature[t] = source.curvature[f];
    target.stretch[t] = source.stretch[f];
    target.gauss[t] = source.gauss[f];
  };
  for (std::size_t lane = 0; lane < capacity; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    std::size_t count = arm_count_[lane];
    if (lane >= size_) {
      normal_.set(l, normal_.get(0));
      repeat(0, lane, 0, 0);
      arms_[0].counts[l] = 1;
      count = 1;
    }
    for (std::size_t arm = count; arm < most_arms_; ++arm) {
      repeat(arm, lane, 0, lane);
      arms_[arm].counts[l] = 0;
    }
  }
}

/// step_along_edge() in lanes. With unit normals the two rotations over the plane half way are one, and the
/// cosines follow from the length of the normals' sum.
void UpwindFrames::walk(Arms& arms) const {
  const Lanes3 &n = normal_, &q = arms.normal, &e1 = arms.e1, &chord = arms.chord;
  const Lanes3 sum{q.x + n.x, q.y + n.y, q.z + n.z};
  const Lanes squared_sum = dot(sum, sum), size = squared_sum.sqrt(), inverse = size.inverse();
  const Lanes3 middle{sum.x * inverse, sum.y * inverse, sum.z * inverse};

  const Lanes along = dot(e1, n) * inverse, whole = 2 * along;
  arms.carried = {e1.x - whole * middle.x, e1.y - whole * middle.y, e1.z - whole * middle.z};
  const Lanes half = along / (1 + size / 2);
  const Lanes3 e{e1.x - half * (q.x + middle.x), e1.y - half * (q.y + middle.y),
                 e1.z - half * (q.z + middle.z)};
  const Lanes3 left = cross(middle, e);

  const Lanes ahead = dot(chord, e), beside = dot(chord, left);
  const Lanes squared = dot(chord, chord), flat = ahead * ahead + beside * beside;
  const Lanes3 turn{n.x - q.x, n.y - q.y, n.z - q.z};
  const Lanes scale = (squared / flat).sqrt();
  const Lanes bend = dot(turn, chord) / (24 * dot(turn, turn).max(1));
  arms.length = squared.sqrt();
  arms.u = ahead * scale + bend * dot(turn, e);
  arms.v = beside * scale + bend * dot(turn, left);

  // Opposite normals, and edges along the normal or too short for their squares.
  constexpr float opposite = 0.002F, least_square = std::numeric_limits<float>::min();
  if (squared_sum.minCoeff() > opposite && flat.minCoeff() > least_square) return;
  for (Eigen::Index lane = 0; lane < squared.size(); ++lane)
    if (!(squared_sum[lane] > opposite && flat[lane] > least_square)) walk_exactly(arms, lane);
}

void UpwindFrames::walk_exactly(Arms& arms, Eigen::Index lane) const {
  const Vec3f chord = arms.chord.get(lane);
  const auto [step, e1] =
      step_along_edge(Vec3f::Zero(), arms.normal.get(lane), arms.e1.get(lane), chord, normal_.get(lane));
  arms.u[lane] = step.x();
  arms.v[lane] = step.y();
  arms.length[lane] = chord.norm();
  arms.carried.set(lane, e1);
}

/// An arm along the geodesic from the stroke knows most of x; what it has to add for its way across is what
/// is uncertain.
void UpwindFrames::weigh_second() {
  constexpr float sideways = 0.3F;
  for (std::size_t i = 0; i < most_arms_; ++i) {
    Arms& arms = arms_[i];
    arms.weight =
        squared_unit_ * arms.counts / (arms.across.square() + sideways * (arms.length + epsilon_).square());
  }
}

/// k and J at x: weighted least squares of what the arms tell over their u, at u = 0. The slope is damped in
/// proportion to how little the arms spread over u.
void UpwindFrames::find_shapes() {
  constexpr float damping = 0.03F;
  Lanes weights = Lanes::Zero(), u = weights, uu = weights, vv = weights, k = weights, j = weights,
        ku = weights, ju = weights, turn = weights, least = Lanes::Constant(1);
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    const Lanes w = arms.weight, wu = w * arms.across, squared_v = arms.out.square();
    const Lanes straight = 1 - arms.curvature * arms.out;
    Lanes stretch = arms.stretch * (straight - arms.gauss * squared_v / 2);
    Lanes curvature = arms.curvature / straight + arms.gauss * arms.out;
    if (near_ends_) find_round_shapes(arms, curvature, stretch);
    turn = turn.max(arms.curvature.square() * (arms.across.square() + squared_v));
    least = least.min(stretch);
    weights += w;
    u += wu;
    uu += wu * arms.across;
    vv += w * squared_v;
    k += w * curvature;
    j += w * stretch;
    ku += wu * curvature;
    ju += wu * stretch;
  }
  const Lanes inverse = weights.inverse(), u_mean = u * inverse, uu_mean = uu * inverse;
  // Adding the least float keeps the lever finite where there is no spread.
  const Lanes spread = (uu_mean - u_mean.square()).max(0) + damping * (uu_mean + vv * inverse) +
                       std::numeric_limits<float>::min();
  const Lanes lever = u_mean / spread;
  const Lanes k_mean = k * inverse, j_mean = j * inverse;
  curvature_ = k_mean - (ku * inverse - u_mean * k_mean) * lever;
  stretch_ = (j_mean - (ju * inverse - u_mean * j_mean) * lever).max(least_stretch);
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    focal_[lane] = !(turn[l] <= largest_turn * largest_turn && least[l] >= least_stretch);
  }
}

void UpwindFrames::find_tangents() {
  Lanes3 ahead{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()}, beside = ahead;
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    // Turned by a mean of both curvatures; cos and sin of small angles, within 1e-7 up to half a radian.
    Lanes angle = (arms.curvature + arms.share_at_x * (curvature_ - arms.curvature)) * arms.u;
    if (near_ends_) turn_with_rays(arms, angle);
    const Lanes squared = angle.square();
    const Lanes cosine = arms.weight * (1 - squared * (0.5F - squared * (1 / 24.F - squared / 720)));
    const Lanes sine = arms.weight * angle * (1 - squared * (1 / 6.F - squared / 120));
    ahead.x += cosine * arms.carried.x;
    ahead.y += cosine * arms.carried.y;
    ahead.z += cosine * arms.carried.z;
    beside.x += sine * arms.carried.x;
    beside.y += sine * arms.carried.y;
    beside.z += sine * arms.carried.z;
  }
  const Lanes3 left = cross(normal_, beside);
  const Lanes3 sum{ahead.x + left.x, ahead.y + left.y, ahead.z + left.z};
  const Lanes up = dot(sum, normal_);
  e1_ = {sum.x - up * normal_.x, sum.y - up * normal_.y, sum.z - up * normal_.z};
  const Lanes squared = dot(e1_, e1_), inverse = squared.sqrt().inverse();
  e1_ = {e1_.x * inverse, e1_.y * inverse, e1_.z * inverse};
  // Nothing left but rounding, or squares out of the range of floats.
  constexpr float least_part = 1e-6F, least_square = 1e-20F, most_square = 1e30F;
  const Lanes whole = dot(sum, sum);
  const Lanes safe = (squared - least_part * whole).min(squared - least_square).min(most_square - whole);
  if (safe.minCoeff() > 0) return;
  for (Eigen::Index lane = 0; lane < safe.size(); ++lane)
    if (!(safe[lane] > 0)) e1_.set(lane, unit_tangent(sum.get(lane), normal_.get(lane)));
}

void UpwindFrames::find_coordinates() {
  const Lanes3 right = cross(e1_, normal_);
  const Lanes inverse_stretch = stretch_.inverse();
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    // The arm's step in the basis of the frame at x.
    const Lanes cosine = dot(arms.carried, e1_), sine = dot(arms.carried, right);
    const Lanes u = arms.u * cosine + arms.v * sine, v = arms.v * cosine - arms.u * sine;
    weights += arms.weight;
    Lanes t_at_q = arms.u / arms.stretch, d_at_q = arms.v, t_at_x = u * inverse_stretch, d_at_x = v;
    if (near_ends_) {
      go_along_rays(arms.rays, arms.stretch.inverse(), arms.u, arms.v, t_at_q, d_at_q);
      go_along_rays(rays_, inverse_stretch, u, v, t_at_x, d_at_x);
    }
    t += arms.weight * (arms.t + t_at_q + arms.share_at_x * (t_at_x - t_at_q));
    d += arms.weight * (arms.d + d_at_q + arms.share_at_x * (d_at_x - d_at_q));
  }
  const Lanes inverse = weights.inverse();
  t_ = t * inverse;
  d_ = d * inverse;
}

/// Means of what the first order makes of the arms.
void UpwindFrames::find_first_order() {
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  Lanes3 e1{weights, weights, weights};
  for (std::size_t i = 0; i < most_arms_; ++i) {
    const Arms& arms = arms_[i];
    const Lanes w = arms.counts / (arms.length + epsilon_);
    weights += w;
    t += w * (arms.t + arms.u);
    d += w * (arms.d + arms.v);
    e1.x += w * arms.carried.x;
    e1.y += w * arms.carried.y;
    e1.z += w * arms.carried.z;
  }
  t_ = t / weights;
  d_ = d / weights;
  for (Eigen::Index lane = 0; lane < t_.size(); ++lane)
    e1_.set(lane, unit_tangent(e1.get(lane), normal_.get(lane)));
}

/// The frame that one arm by itself tells, taking lines of constant d beside the stroke for circles. t
/// relative to the origin.
ChartFrame UpwindFrames::told_by(const Arms& arms, Eigen::Index lane) const {
  const ChartFrame at_q{.t = static_cast<double>(arms.t[lane]),
                        .d = arms.d[lane],
                        .curvature = arms.curvature[lane],
                        .stretch = arms.stretch[lane]};
  const FrameStep step{Vec2f(arms.u[lane], arms.v[lane]), arms.carried.get(lane)};
  const Rays& rays = arms.rays;
  const bool from_end = near_ends_ && rays.from_end[lane];
  const DistanceRay ray =
      from_end ? DistanceRay{rays.ahead[lane], rays.left[lane], rays.length[lane], rays.inverse_length[lane]}
               : DistanceRay{};
  return propagate_frame(at_q, ray, step, normal_.get(lane), arms.gauss[lane]);
}

/// Means of what the arms of one node tell by themselves.
void UpwindFrames::find_on_circles(Eigen::Index lane) {
  double weights = 0, t = 0;
  float d = 0, k = 0, j = 0;
  Vec3f e1 = Vec3f::Zero();
  for (std::size_t i = 0; i < arm_count_[static_cast<std::size_t>(lane)]; ++i) {
    const float w = arms_[i].weight[lane];
    if (!(w > 0)) continue;
    const ChartFrame told = told_by(arms_[i], lane);
    weights += static_cast<double>(w);
    t += static_cast<double>(w) * told.t;
    d += w * told.d;
    k += w * told.curvature;
    j += w * told.stretch;
    e1 += w * told.e1;
  }
  const auto whole = static_cast<float>(weights);
  t_[lane] = static_cast<float>(t / weights);
  d_[lane] = d / whole;
  if (!at_end_[static_cast<std::size_t>(lane)]) {
    curvature_[lane] = k / whole;
    stretch_[lane] = j / whole;
  }
  e1_.set(lane, unit_tangent(e1, normal_.get(lane)));
}

const std::array<ChartFrame, UpwindFrames::capacity>& UpwindFrames::compute() {
  fill_up();
  for (std::size_t i = 0; i < most_arms_; ++i) walk(arms_[i]);
  find_ends();
  keep_agreeing();
  weigh_second();
  if (order_ == 1) {
    find_first_order();
    curvature_ = 0;
    stretch_ = 1;
  } else {
    find_shapes();
    pass_ends();
    find_tangents();
    find_coordinates();
    for (std::size_t lane = 0; lane < size_; ++lane)
      if (focal_[lane]) find_on_circles(static_cast<Eigen::Index>(lane));
  }
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    frames_[lane] = {origin_[lane] + static_cast<double>(t_[l]), d_[l], e1_.get(l), curvature_[l],
                     stretch_[l]};
  }
  return frames_;
}

}  // namespace burin
