// Second order. In Fermi coordinates (t, d) along the stroke, with k the geodesic curvature of the lines of
// constant d, J the stretch of t and K the Gauss curvature, a step of the vector (u, v) from q to x changes
//   k by K v + k^2 v,  J by -J (k v + K v^2 / 2),  the angle of e1 by k u,  t by u / J,  d by v
// per unit of length; beyond round ends to the like around these. k and J come first, from q alone; they vary
// along t as well, which q cannot know, so the mean over the edges is taken where the line through their
// values over u has u = 0. Then e1, t and d are integrated by the trapezoidal rule between the frames of q
// and x, which needs no derivative of k or J.
//
// Around corners, where k is beyond that, lines of constant d are circles, and each edge tells the frame at x
// by itself. Where parts of the stroke meet, the edge holds that places x nearest to the stroke, and those
// that agree with it.
#include <burin/chart/frames/frame_step.h>
#include <burin/chart/frames/propagate_frame.h>
#include <burin/chart/front/leader.h>
#include <burin/chart/front/upwind_frames.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  if (size_ == 0) most_edges_ = 0;
  edge_count_[size_++] = 0;
  position_.set(lane, x.position);
  normal_.set(lane, x.normal);
  gauss_[lane] = x.gauss;
  g_[lane] = x.g();
}

void UpwindFrames::add_edge(const FrontNode& q, double t) {
  const std::size_t node = size_ - 1, edge = edge_count_[node]++;
  const auto lane = static_cast<Eigen::Index>(node);
  if (edge == 0) origin_[node] = t;
  most_edges_ = std::max(most_edges_, edge + 1);
  if (edges_.size() < most_edges_) edges_.resize(most_edges_);
  Edges& edges = edges_[edge];
  edges.normal.set(lane, q.normal);
  edges.e1.set(lane, q.frame.e1);
  edges.chord.set(lane, position_.get(lane) - q.position);
  edges.t[lane] = static_cast<float>(t - origin_[node]);
  edges.d[lane] = q.frame.d;
  edges.curvature[lane] = q.frame.curvature;
  edges.stretch[lane] = q.frame.stretch;
  edges.gauss[lane] = (gauss_[lane] + q.gauss) / 2;
  edges.g[lane] = q.g();
  edges.shortfall[lane] = shortfall_of(q, *path_);
  edges.counts[lane] = 1;
}

/// Repeats nodes in lanes, and edges in nodes, that there are too few of. Repeated edges do not count.
void UpwindFrames::fill_up() {
  const auto repeat = [this](std::size_t to_edge, std::size_t to, std::size_t from_edge, std::size_t from) {
    Edges& target = edges_[to_edge];
    const Edges& source = edges_[from_edge];
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
    std::size_t count = edge_count_[lane];
    if (lane >= size_) {
      normal_.set(l, normal_.get(0));
      repeat(0, lane, 0, 0);
      edges_[0].counts[l] = 1;
      count = 1;
    }
    for (std::size_t edge = count; edge < most_edges_; ++edge) {
      repeat(edge, lane, 0, lane);
      edges_[edge].counts[l] = 0;
    }
  }
}

/// step_along_edge() in lanes. With unit normals the two rotations over the plane half way are one, and the
/// cosines follow from the length of the normals' sum.
void UpwindFrames::walk(Edges& edges) const {
  const Lanes3 &n = normal_, &q = edges.normal, &e1 = edges.e1, &chord = edges.chord;
  const Lanes3 sum{q.x + n.x, q.y + n.y, q.z + n.z};
  const Lanes squared_sum = dot(sum, sum), size = squared_sum.sqrt(), inverse = size.inverse();
  const Lanes3 middle{sum.x * inverse, sum.y * inverse, sum.z * inverse};

  const Lanes along = dot(e1, n) * inverse, whole = 2 * along;
  edges.carried = {e1.x - whole * middle.x, e1.y - whole * middle.y, e1.z - whole * middle.z};
  const Lanes half = along / (1 + size / 2);
  const Lanes3 e{e1.x - half * (q.x + middle.x), e1.y - half * (q.y + middle.y),
                 e1.z - half * (q.z + middle.z)};
  const Lanes3 left = cross(middle, e);

  const Lanes ahead = dot(chord, e), beside = dot(chord, left);
  const Lanes squared = dot(chord, chord), flat = ahead * ahead + beside * beside;
  const Lanes3 turn{n.x - q.x, n.y - q.y, n.z - q.z};
  const Lanes scale = (squared / flat).sqrt();
  const Lanes bend = dot(turn, chord) / (24 * dot(turn, turn).max(1));
  edges.length = squared.sqrt();
  edges.u = ahead * scale + bend * dot(turn, e);
  edges.v = beside * scale + bend * dot(turn, left);

  // Opposite normals, and edges along the normal or too short for their squares.
  constexpr float opposite = 0.002F, least_square = std::numeric_limits<float>::min();
  if (squared_sum.minCoeff() > opposite && flat.minCoeff() > least_square) return;
  for (Eigen::Index lane = 0; lane < squared.size(); ++lane)
    if (!(squared_sum[lane] > opposite && flat[lane] > least_square)) walk_exactly(edges, lane);
}

void UpwindFrames::walk_exactly(Edges& edges, Eigen::Index lane) const {
  const Vec3f chord = edges.chord.get(lane);
  const auto [step, e1] =
      step_along_edge(Vec3f::Zero(), edges.normal.get(lane), edges.e1.get(lane), chord, normal_.get(lane));
  edges.u[lane] = step.x();
  edges.v[lane] = step.y();
  edges.length[lane] = chord.norm();
  edges.carried.set(lane, e1);
}

/// Returns the greatest t at which an edge may place its node, relative to the node's origin. Edges are held
/// against the stroke there, and against its end.
UpwindFrames::Lanes UpwindFrames::find_reach() {
  Lanes farthest = Lanes::Constant(-unreached);
  for (std::size_t i = 0; i < most_edges_; ++i) {
    Edges& edges = edges_[i];
    // However a step turns, it does not go farther.
    constexpr float quarter = std::numbers::pi_v<float> / 2;
    edges.reach = quarter * edges.length / edges.stretch;
    farthest = farthest.max(edges.t + edges.reach);
  }
  return farthest;
}

/// An edge along the geodesic from the stroke knows most of x; what it has to add for its way across is what
/// is uncertain.
void UpwindFrames::weigh_second() {
  constexpr float sideways = 0.3F;
  for (std::size_t i = 0; i < most_edges_; ++i) {
    Edges& edges = edges_[i];
    edges.weight = squared_unit_ * edges.counts /
                   (edges.across.square() + sideways * (edges.length + epsilon_).square());
  }
}

/// k and J at x: weighted least squares of what the edges tell over their u, at u = 0. The slope is damped in
/// proportion to how little the edges spread over u.
UpwindFrames::FoundShapes UpwindFrames::find_shapes(bool near_ends) const {
  constexpr float damping = 0.03F;
  Lanes weights = Lanes::Zero(), u = weights, uu = weights, vv = weights, k = weights, j = weights,
        ku = weights, ju = weights, turn = weights, least = Lanes::Constant(1);
  for (std::size_t i = 0; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    const Lanes w = edges.weight, wu = w * edges.across, squared_v = edges.out.square();
    const Lanes straight = 1 - edges.curvature * edges.out;
    Shapes there{edges.curvature / straight + edges.gauss * edges.out,
                 edges.stretch * (straight - edges.gauss * squared_v / 2)};
    if (near_ends) find_round_shapes(edges, there);
    turn = turn.max(edges.curvature.square() * (edges.across.square() + squared_v));
    least = least.min(there.stretch);
    weights += w;
    u += wu;
    uu += wu * edges.across;
    vv += w * squared_v;
    k += w * there.curvature;
    j += w * there.stretch;
    ku += wu * there.curvature;
    ju += wu * there.stretch;
  }
  const Lanes inverse = weights.inverse(), u_mean = u * inverse, uu_mean = uu * inverse;
  // Adding the least float keeps the lever finite where there is no spread.
  const Lanes spread = (uu_mean - u_mean.square()).max(0) + damping * (uu_mean + vv * inverse) +
                       std::numeric_limits<float>::min();
  const Lanes lever = u_mean / spread;
  const Lanes k_mean = k * inverse, j_mean = j * inverse;
  FoundShapes found{{k_mean - (ku * inverse - u_mean * k_mean) * lever,
                     (j_mean - (ju * inverse - u_mean * j_mean) * lever).max(least_stretch)}};
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    found.focal[lane] = !(turn[l] <= largest_turn * largest_turn && least[l] >= least_stretch);
  }
  return found;
}

UpwindFrames::Lanes3 UpwindFrames::find_tangents(const PassedEnds& passed) const {
  Lanes3 ahead{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()}, beside = ahead;
  for (std::size_t i = 0; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    // Turned by a mean of both curvatures; cos and sin of small angles, within 1e-7 up to half a radian.
    Lanes angle =
        (edges.curvature + edges.share_at_x * (passed.shapes.curvature - edges.curvature)) * edges.u;
    if (passed.near) turn_with_rays(edges, passed, angle);
    const Lanes squared = angle.square();
    const Lanes cosine = edges.weight * (1 - squared * (0.5F - squared * (1 / 24.F - squared / 720)));
    const Lanes sine = edges.weight * angle * (1 - squared * (1 / 6.F - squared / 120));
    ahead.x += cosine * edges.carried.x;
    ahead.y += cosine * edges.carried.y;
    ahead.z += cosine * edges.carried.z;
    beside.x += sine * edges.carried.x;
    beside.y += sine * edges.carried.y;
    beside.z += sine * edges.carried.z;
  }
  const Lanes3 left = cross(normal_, beside);
  const Lanes3 sum{ahead.x + left.x, ahead.y + left.y, ahead.z + left.z};
  const Lanes up = dot(sum, normal_);
  const Lanes3 level{sum.x - up * normal_.x, sum.y - up * normal_.y, sum.z - up * normal_.z};
  const Lanes squared = dot(level, level), inverse = squared.sqrt().inverse();
  Lanes3 e1{level.x * inverse, level.y * inverse, level.z * inverse};
  // Nothing left but rounding, or squares out of the range of floats.
  constexpr float least_part = 1e-6F, least_square = 1e-20F, most_square = 1e30F;
  const Lanes whole = dot(sum, sum);
  const Lanes safe = (squared - least_part * whole).min(squared - least_square).min(most_square - whole);
  if (safe.minCoeff() > 0) return e1;
  for (Eigen::Index lane = 0; lane < safe.size(); ++lane)
    if (!(safe[lane] > 0)) e1.set(lane, unit_tangent(sum.get(lane), normal_.get(lane)));
  return e1;
}

UpwindFrames::Frames UpwindFrames::find_coordinates(const PassedEnds& passed, const Lanes3& e1) const {
  const Lanes3 right = cross(e1, normal_);
  const Lanes inverse_stretch = passed.shapes.stretch.inverse();
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  for (std::size_t i = 0; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    // The edge's step in the basis of the frame at x.
    const Lanes cosine = dot(edges.carried, e1), sine = dot(edges.carried, right);
    const Lanes u = edges.u * cosine + edges.v * sine, v = edges.v * cosine - edges.u * sine;
    weights += edges.weight;
    Lanes t_at_q = edges.u / edges.stretch, d_at_q = edges.v, t_at_x = u * inverse_stretch, d_at_x = v;
    if (passed.near) {
      go_along_rays(edges.rays, edges.stretch.inverse(), edges.u, edges.v, t_at_q, d_at_q);
      go_along_rays(passed.rays, inverse_stretch, u, v, t_at_x, d_at_x);
    }
    t += edges.weight * (edges.t + t_at_q + edges.share_at_x * (t_at_x - t_at_q));
    d += edges.weight * (edges.d + d_at_q + edges.share_at_x * (d_at_x - d_at_q));
  }
  const Lanes inverse = weights.inverse();
  return {t * inverse, d * inverse, e1, passed.shapes, {}};
}

/// Means of what the first order makes of the edges.
UpwindFrames::Frames UpwindFrames::first_order() const {
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  Lanes3 e1{weights, weights, weights};
  for (std::size_t i = 0; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    const Lanes w = edges.counts / (edges.length + epsilon_);
    weights += w;
    t += w * (edges.t + edges.u);
    d += w * (edges.d + edges.v);
    e1.x += w * edges.carried.x;
    e1.y += w * edges.carried.y;
    e1.z += w * edges.carried.z;
  }
  for (Eigen::Index lane = 0; lane < weights.size(); ++lane)
    e1.set(lane, unit_tangent(e1.get(lane), normal_.get(lane)));
  return {t / weights, d / weights, e1, {Lanes::Zero(), Lanes::Ones()}, {}};
}

/// Takes lines of constant d beside the stroke for circles. t is relative to the origin.
ChartFrame UpwindFrames::propagated_along(const Edges& edges, Eigen::Index lane, bool near_ends) const {
  const ChartFrame at_q{.t = static_cast<double>(edges.t[lane]),
                        .d = edges.d[lane],
                        .curvature = edges.curvature[lane],
                        .stretch = edges.stretch[lane]};
  const FrameStep step{Vec2f(edges.u[lane], edges.v[lane]), edges.carried.get(lane)};
  const Rays& rays = edges.rays;
  const bool from_end = near_ends && rays.from_end[lane];
  const DistanceRay ray =
      from_end ? DistanceRay{rays.ahead[lane], rays.left[lane], rays.length[lane], rays.inverse_length[lane]}
               : DistanceRay{};
  return propagate_frame(at_q, ray, step, normal_.get(lane), edges.gauss[lane]);
}

/// Means of the frames that the edges of one node give by themselves.
void UpwindFrames::find_on_circles(Eigen::Index lane, const PassedEnds& passed, Frames& frames) const {
  double weights = 0, t = 0;
  float d = 0, k = 0, j = 0;
  Vec3f e1 = Vec3f::Zero();
  for (std::size_t i = 0; i < edge_count_[static_cast<std::size_t>(lane)]; ++i) {
    const float w = edges_[i].weight[lane];
    if (!(w > 0)) continue;
    const ChartFrame propagated = propagated_along(edges_[i], lane, passed.near);
    weights += static_cast<double>(w);
    t += static_cast<double>(w) * propagated.t;
    d += w * propagated.d;
    k += w * propagated.curvature;
    j += w * propagated.stretch;
    e1 += w * propagated.e1;
  }
  const auto whole = static_cast<float>(weights);
  frames.t[lane] = static_cast<float>(t / weights);
  frames.d[lane] = d / whole;
  if (!passed.at_end[static_cast<std::size_t>(lane)]) {
    frames.shapes.curvature[lane] = k / whole;
    frames.shapes.stretch[lane] = j / whole;
  }
  frames.e1.set(lane, unit_tangent(e1, normal_.get(lane)));
}

UpwindFrames::Frames UpwindFrames::second_order(const Ends& ends) {
  weigh_second();
  const FoundShapes found = find_shapes(ends.near);
  const PassedEnds passed = pass_ends(ends, found.shapes);
  Frames frames = find_coordinates(passed, find_tangents(passed));
  for (std::size_t lane = 0; lane < size_; ++lane)
    if (found.focal[lane]) find_on_circles(static_cast<Eigen::Index>(lane), passed, frames);
  frames.focal = found.focal;
  return frames;
}

UpwindFrames::Result UpwindFrames::compute() {
  fill_up();
  for (std::size_t i = 0; i < most_edges_; ++i) walk(edges_[i]);
  const Lanes farthest = find_reach();
  const Ends ends = find_ends();
  const LaneFlags left_out = keep_agreeing(ends.near);
  const Frames found = order_ == 1 ? first_order() : second_order(ends);
  Result result;
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    result.frames[lane] = {origin_[lane] + static_cast<double>(found.t[l]), found.d[l], found.e1.get(l),
                           found.shapes.curvature[l], found.shapes.stretch[l]};
    result.contested[lane] = found.focal[lane] || left_out[lane];
    if (order_ == 2 && tells_too_far(result.frames[lane], l)) {
      result.frames[lane] = of_nearest(l, ends.near);
      result.contested[lane] = true;
    }
    result.depends_to[lane] = origin_[lane] + static_cast<double>(farthest[l]) + path_->spacing();
  }
  return result;
}

}  // namespace burin
