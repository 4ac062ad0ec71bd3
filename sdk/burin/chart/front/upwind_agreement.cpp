// Which edges of a node tell its frame: where parts of the stroke meet, the one that places it nearest to the
// stroke and those that agree with it.
#include <burin/chart/front/leader.h>
#include <burin/chart/front/upwind_frames.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Edges that agree count about half that place x as far from where the nearest does, in lengths of both, and
/// at least so much.
constexpr float doubtful_apart_in_d = 0.05F, least_count = 0.5F;

/// Edges agree that place x this near to each other: t and d, in lengths of the edges. Edges of other
/// directions (1 - cosine) agree in d only as far as they do by chance.
constexpr float apart_in_t = 2, apart_in_d = 0.5F, least_apart_in_d = 0.02F, other_direction = 0.3F;

/// Frames turn false where surfaces are rough: where normals turn by this along an edge, in radians, and in
/// proportion below. On flat ground a way along which the distance stands still is as true as any.
constexpr float rough_turn = 0.1F;

}  // namespace

UpwindFrames::LaneFlags UpwindFrames::keep_agreeing(bool near_ends) {
  LaneFlags left_out{};
  const auto t_along = [near_ends](const Edges& edges) {
    const Lanes t = edges.t + edges.u;
    return near_ends ? Lanes(edges.rays.from_end.select(edges.placed_t, t)) : t;
  };
  const auto d_along = [near_ends](const Edges& edges) {
    const Lanes &u = edges.u, &v = edges.v, &k = edges.curvature;
    const Lanes size = ((k * u).square() + (1 - k * v).square()).sqrt();
    const Lanes d = edges.d + (2 * v - k * (u.square() + v.square())) / (1 + size);
    return near_ends ? Lanes(edges.rays.from_end.select(edges.placed_d, d)) : d;
  };
  Lanes t_low = t_along(edges_[0]), t_high = t_low, d_low = d_along(edges_[0]), d_high = d_low,
        shortest = edges_[0].length;
  for (std::size_t i = 1; i < most_edges_; ++i) {
    const Edges& edges = edges_[i];
    const Lanes t = t_along(edges), d = d_along(edges);
    t_low = t_low.min(t);
    t_high = t_high.max(t);
    d_low = d_low.min(d);
    d_high = d_high.max(d);
    shortest = shortest.min(edges.length);
  }
  // Where no two are farther apart than the shortest edges allow there is nothing to choose from.
  const Lanes apart =
      (t_high - t_low - apart_in_t * shortest).max(d_high - d_low - least_apart_in_d * shortest);
  if (apart.maxCoeff() <= 0) return left_out;
  for (std::size_t lane = 0; lane < size_; ++lane)
    left_out[lane] = !(apart[static_cast<Eigen::Index>(lane)] <= 0) &&
                     keep_agreeing(static_cast<Eigen::Index>(lane), near_ends);
  return left_out;
}

/// How much the normals turn along an edge, about radians.
float UpwindFrames::turn_along(std::size_t edge, Eigen::Index lane) const {
  return (normal_.get(lane) - edges_[edge].normal.get(lane)).norm();
}

/// Of the edges that count, the one that places x nearest to the stroke; leaves the frames that the edges
/// give in propagated_.
std::size_t UpwindFrames::find_nearest(Eigen::Index lane, bool near_ends) {
  const std::size_t count = edge_count_[static_cast<std::size_t>(lane)];
  propagated_.clear();
  float least = unreached;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    propagated_.push_back(propagated_along(edges_[i], lane, near_ends));
    if (!(edges_[i].counts[lane] > 0)) continue;
    const double t = origin_[static_cast<std::size_t>(lane)] + propagated_[i].t;
    const auto at =
        static_cast<float>(path_->distance(t, static_cast<double>(propagated_[i].d), position_.get(lane)));
    const float doubtful_length = std::min(turn_along(i, lane) / rough_turn, 1.0F) * edges_[i].length[lane];
    const float distance = distance_along(edges_[i].g[lane], edges_[i].shortfall[lane], doubtful_length, at);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

/// Whether one does not count.
bool UpwindFrames::keep_agreeing(Eigen::Index lane, bool near_ends) {
  const std::size_t count = edge_count_[static_cast<std::size_t>(lane)];
  const std::size_t nearest = find_nearest(lane, near_ends);
  const std::vector<ChartFrame>& propagated = propagated_;
  bool some_left_out = false;
  for (std::size_t i = 0; i < count; ++i) {
    const float reach = edges_[i].length[lane] + edges_[nearest].length[lane];
    const float otherwise = (1 - propagated[i].e1.dot(propagated[nearest].e1)) / other_direction;
    const float in_d = std::max(apart_in_d * (1 - otherwise), least_apart_in_d) / 2;
    const auto t = static_cast<float>(std::abs(propagated[i].t - propagated[nearest].t));
    const float d = std::abs(propagated[i].d - propagated[nearest].d);
    if (t <= apart_in_t * reach && d <= in_d * reach) {
      const float doubts = d / (doubtful_apart_in_d * reach);
      // Where the surface is rough their differences are chance, and the mean of all is nearer to the truth.
      edges_[i].counts[lane] = least_count + (1 - least_count) / (1 + doubts * doubts);
      continue;
    }
    leave_out(i, lane);
    some_left_out = true;
  }
  // Repeats of an edge that is left out have no say in what is near a focal point either.
  for (std::size_t i = count; i < most_edges_; ++i) leave_out(i, lane);
  return some_left_out;
}

/// Whether a frame is farther from the stroke than the best edge of its node allows: edges agree roughly
/// only, and where one of two leads around a corner or an end of the stroke their mean may be beyond both. On
/// rough ground it is g that is left to chance.
bool UpwindFrames::tells_too_far(const ChartFrame& frame, Eigen::Index lane) const {
  constexpr double most_doubts = 7;
  const double told = path_->chart_distance(frame.t, static_cast<double>(frame.d));
  if (!(told > static_cast<double>(g_[lane]) + most_doubts * path_->doubt())) return false;
  for (std::size_t i = 0; i < edge_count_[static_cast<std::size_t>(lane)]; ++i)
    if (turn_along(i, lane) > rough_turn) return false;
  return true;
}

ChartFrame UpwindFrames::of_nearest(Eigen::Index lane, bool near_ends) {
  ChartFrame frame = propagated_[find_nearest(lane, near_ends)];
  frame.t += origin_[static_cast<std::size_t>(lane)];
  return frame;
}

void UpwindFrames::leave_out(std::size_t edge, Eigen::Index lane) {
  Edges& edges = edges_[edge];
  edges.counts[lane] = edges.curvature[lane] = edges.gauss[lane] = 0;
  edges.stretch[lane] = 1;
}

}  // namespace burin
