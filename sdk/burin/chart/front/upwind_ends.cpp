// Where t comes near an end of the stroke or is beyond it. Round ends have coordinates of their own around
// them, see DistanceRay; where the stroke does not end round it goes on as a geodesic, so that k and J jump
// where t passes an end of a curved stroke.
#include <burin/chart/front/upwind_frames.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace {

/// From this k d on a curve's coordinates fold beside it.
constexpr float most_bend = 0.5F;

}  // namespace

/// Finds how far the nodes may be beyond the ends, and if any is, the rays of all edges.
UpwindFrames::Ends UpwindFrames::find_ends() {
  for (std::size_t i = 0; i < most_edges_; ++i) {
    Edges& edges = edges_[i];
    edges.across = edges.u;
    edges.out = edges.v;
    edges.share_at_x = 0.5F;
  }
  Ends found;
  if (path_->closed() || order_ == 1) return found;
  found.ends = {find_end(0, -1, path_->round_begin()), find_end(path_->length(), 1, path_->round_end())};
  found.near = found.ends[0].most.maxCoeff() > 0 || found.ends[1].most.maxCoeff() > 0;
  if (!found.near) return found;
  for (std::size_t i = 0; i < most_edges_; ++i) find_rays(edges_[i], found);
  return found;
}

UpwindFrames::End UpwindFrames::find_end(double t, float outward, bool round) const {
  End end;
  end.outward = outward;
  end.round = round;
  for (std::size_t lane = 0; lane < capacity; ++lane)
    end.t[static_cast<Eigen::Index>(lane)] = static_cast<float>(t - origin_[lane < size_ ? lane : 0]);
  end.most = -unreached;
  end.least = unreached;
  for (std::size_t i = 0; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    const Lanes before = outward * (edges.t - end.t);
    end.most = end.most.max(before + edges.reach);
    end.least = end.least.min(before - edges.reach);
  }
  return end;
}

void UpwindFrames::find_rays(Edges& edges, const Ends& ends) {
  const auto& [begin, end] = ends.ends;
  Lanes past = Lanes::Zero();
  if (begin.round) past += (edges.t - begin.t).min(0);
  if (end.round) past += (edges.t - end.t).max(0);
  edges.rays = rays_to(past, edges.d);
  const Rays& rays = edges.rays;
  const RayParts<Lanes> parts = in_parts(rays, edges.u, edges.v);
  edges.across = rays.from_end.select(parts.across, edges.u);
  edges.out = rays.from_end.select(parts.out, edges.v);
  // These are the formulas of ray_step().
  const Lanes inverse = edges.stretch.inverse(), bend = bend_across(rays, edges.curvature, inverse);
  const Lanes beside = edges.across * inverse * (1 + edges.curvature * edges.out),
              away = edges.out - bend * edges.across.square() / 2;
  const Lanes t = rays.left * beside + rays.ahead * away;
  edges.placed_t = edges.t + t;
  edges.placed_d = edges.d + rays.left * away - rays.ahead * beside;
  edges.placed_length = ((past + t).square() + edges.placed_d.square()).sqrt();
}

/// The rays from a round end to frames so far past it, and at d.
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
void UpwindFrames::turn_with_rays(const Edges& edges, const PassedEnds& passed, Lanes& angle) {
  const auto turn = [&](const Rays& rays, const Lanes& curvature, const Lanes& stretch) -> Lanes {
    return turn_across(rays, curvature, Lanes(stretch.inverse())) * in_parts(rays, edges.u, edges.v).across;
  };
  const Lanes at_q = turn(edges.rays, edges.curvature, edges.stretch),
              at_x = turn(passed.rays, passed.shapes.curvature, passed.shapes.stretch);
  angle =
      (edges.rays.from_end || passed.rays.from_end).select(at_q + edges.share_at_x * (at_x - at_q), angle);
}

/// k and J that edges around an end tell.
void UpwindFrames::find_round_shapes(const Edges& edges, Shapes& shapes) {
  const RoundShape<Lanes> shape = farther_out<Lanes>({edges.curvature, edges.stretch}, edges.rays.length,
                                                     edges.placed_length, edges.gauss);
  const auto sound = (shape.stretch > least_stretch).eval();
  shapes.stretch = edges.rays.from_end.select(shape.stretch, shapes.stretch);
  shapes.curvature =
      edges.rays.from_end.select(sound.select(shape.curvature, Lanes::Zero()), shapes.curvature);
}

/// What steps of frames around an end add to t and d, to first order; those of others stay.
void UpwindFrames::go_along_rays(const Rays& rays, const Lanes& inverse_stretch, const Lanes& u,
                                 const Lanes& v, Lanes& t, Lanes& d) {
  const auto [across, away] = in_parts(rays, u, v);
  const Lanes beside = across * inverse_stretch;
  t = rays.from_end.select(rays.left * beside + rays.ahead * away, t);
  d = rays.from_end.select(rays.left * away - rays.ahead * beside, d);
}

UpwindFrames::PassedEnds UpwindFrames::pass_ends(const Ends& ends, const Shapes& shapes) {
  PassedEnds passed;
  passed.shapes = shapes;
  passed.near = ends.near;
  if (!ends.near) return passed;
  passed.past = passed.past_d = 0;
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  for (std::size_t i = 0; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    weights += edges.weight;
    t += edges.weight * edges.placed_t;
    d += edges.weight * edges.placed_d;
  }
  const Lanes inverse = weights.inverse();
  for (const End& end : ends.ends) pass_end(end, t * inverse, d * inverse, passed);
  passed.rays = rays_to(passed.past, passed.past_d);
  return passed;
}

/// `t`, `d`: where the edges place the nodes that all of them know to be beyond the end.
void UpwindFrames::pass_end(const End& end, const Lanes& t, const Lanes& d, PassedEnds& passed) {
  for (std::size_t lane = 0; lane < size_; ++lane) {
    const auto l = static_cast<Eigen::Index>(lane);
    if (!(end.most[l] > 0)) continue;
    if (end.least[l] < 0)
      pass_end(end, l, passed);
    else
      place_beyond(end, l, t[l] - end.t[l], d[l], passed);
  }
}

void UpwindFrames::place_beyond(const End& end, Eigen::Index lane, float past, float d, PassedEnds& passed) {
  if (!end.round) return;
  passed.past[lane] = past;
  passed.past_d[lane] = d;
}

/// Of the edges those tell k and J that come from the side of the end on which x is in the mean. Where there
/// is none, as near the end itself, they follow from the curvatures of stroke and surface.
void UpwindFrames::pass_end(const End& end, Eigen::Index lane, PassedEnds& passed) {
  const auto own_lane = static_cast<std::size_t>(lane);
  const float t_end = end.t[lane], outward = end.outward;
  propagated_.clear();
  float weights = 0, beyond = 0, d = 0, gauss = 0, low = unreached, high = -unreached;
  for (std::size_t i = 0; i < edge_count_[own_lane]; ++i) {
    const Edges& edges = edges_[i];
    propagated_.push_back(propagated_along(edges, lane, passed.near));
    const float w = edges.weight[lane], before = outward * (edges.t[lane] - t_end),
                after = outward * (static_cast<float>(propagated_[i].t) - t_end);
    if (!(w > 0)) continue;
    weights += w;
    beyond += w * after;
    d += w * propagated_[i].d;
    gauss += w * edges.gauss[lane];
    low = std::min({low, before, after});
    high = std::max({high, before, after});
  }
  beyond /= weights;
  d /= weights;
  gauss /= weights;
  if (high <= 0) return;
  // Where it is beyond the other end of a short stroke that one tells.
  if (!(beyond > 0) && passed.past[lane] != 0) return;
  if (beyond > 0) place_beyond(end, lane, outward * beyond, d, passed);
  if (low > 0) return;
  passed.at_end[own_lane] = true;
  shape_at_end(end, lane, beyond, d, gauss, passed.shapes);
  float same_side = 0, k = 0, j = 0;
  for (std::size_t i = 0; i < edge_count_[own_lane]; ++i) {
    const float w = edges_[i].weight[lane], before = outward * (edges_[i].t[lane] - t_end),
                after = outward * (static_cast<float>(propagated_[i].t) - t_end);
    if (!(w > 0)) continue;
    if ((before > 0) != (beyond > 0)) {
      if (before * after < 0) edges_[i].share_at_x[lane] = after / (after - before);
      continue;
    }
    same_side += w;
    k += w * propagated_[i].curvature;
    j += w * propagated_[i].stretch;
  }
  if (!(same_side > 0)) return;
  passed.shapes.curvature[lane] = k / same_side;
  passed.shapes.stretch[lane] = j / same_side;
}

/// k and J of a node so far beyond the end, or beside the stroke, that follow from what is known there.
void UpwindFrames::shape_at_end(const End& end, Eigen::Index lane, float beyond, float d, float gauss,
                                Shapes& shapes) const {
  if (beyond > 0 && end.round) {
    const auto [curvature, stretch] = shape_around_end(std::sqrt(beyond * beyond + d * d), gauss);
    shapes.curvature[lane] = stretch > least_stretch ? curvature : 0;
    shapes.stretch[lane] = std::max(stretch, least_stretch);
    return;
  }
  const double t_end = origin_[static_cast<std::size_t>(lane)] + static_cast<double>(end.t[lane]);
  const float of_stroke = beyond > 0 ? 0 : path_->curvature(t_end);
  // On the inside of an end whose centre is near the coordinates fold, and count as straight.
  const float bend = of_stroke * d < most_bend ? of_stroke * d : 0;
  shapes.curvature[lane] = (bend == 0 ? 0 : of_stroke / (1 - bend)) + gauss * d;
  shapes.stretch[lane] = std::max(1 - bend - gauss * d * d / 2, least_stretch);
}

}  // namespace burin
