// Interpolates a growing chart of base nodes to the vertices of the surface. An event costs O(1) per vertex
// in the clusters of changed nodes, of contested nodes near a change, and of nodes near the stroke's end.
#include <burin/base/parallel.h>
#include <burin/chart/frames/mended_frame.h>
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/chart/transfer/chart_transfer.h>
#include <burin/chart/transfer/coordinate_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
void ChartTransfer::update(const LiveChart& nodes, const FrontStroke& on_base, const SurfaceCurve& curve,
                           LiveChart& vertices) {
  uniform_ = has_uniform_width(curve);
  const std::span<const Index> affected = contest_.update(nodes);
  const double from = unchanged_up_to(nodes);
  length_ = nodes.nodes().length;
  vertices.begin_event(length_, false, from);
  ranges_.resize(std::max(ranges_.size(), nodes.nodes().size()));
  for (; first_slot_ > 0; --first_slot_) vertices.remove(first_slot_ - 1);
  for (const Index slot : nodes.removed())
    if (nodes.vacant(slot)) vacate(slot, vertices);
  find_stale(nodes, affected, from);
  make_room(nodes, vertices);
  constexpr std::size_t slots_per_block = 16;
  std::vector<Transferred> transferred((stale_.size() + slots_per_block - 1) / slots_per_block);
  const Event event{nodes, on_base, curve, vertices};
  parallel_blocks(stale_.size(), slots_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      transfer(event, stale_[i], transferred[begin / slots_per_block]);
  });
  for (const Transferred& block : transferred) {
    vertices.note(block.rewritten);
    for (const Index slot : block.gone) vertices.remove(slot);
    for (const auto& [slot, frame, normal] : block.others) vertices.set(slot, vertex_[slot], frame, normal);
  }
}

/// The arc length below which the stroke's end and width decide as before: a vertex with a lower t whose
/// coordinates did not change stays inside or outside the stroke. In contested clusters the same holds for
/// vertices that depend only on nodes with a lower t.
double ChartTransfer::unchanged_up_to(const LiveChart& nodes) const {
  const double ends = std::min(length_, nodes.nodes().length);
  return uniform_ && !contest_.any() ? ends : std::min(ends, nodes.computed_from());
}

void ChartTransfer::find_stale(const LiveChart& nodes, std::span<const Index> affected, double from) {
  stale_.clear();
  is_stale_.resize(ranges_.size());
  const auto add = [&](Index slot) {
    if (is_stale_[slot] || nodes.vacant(slot)) return;
    is_stale_[slot] = 1;
    stale_.push_back(slot);
  };
  for (const Index slot : nodes.computed())
    if (nodes.changed(slot)) add(slot);
  for (const Index slot : affected) add(slot);
  const auto last_t = [this](Index slot) { return ranges_[slot].last_t; };
  for (const Index slot : near_end_.find(from, transferred_, static_cast<Index>(ranges_.size()), last_t))
    if (last_t(slot) >= from) add(slot);
  transferred_ = stale_;
  for (const Index slot : stale_) is_stale_[slot] = 0;
}

/// Reserves slots of the vertices' chart: each slot of the base chart has one for each vertex of its cluster.
void ChartTransfer::make_room(const LiveChart& nodes, LiveChart& vertices) {
  for (const Index slot : stale_) {
    Range& range = ranges_[slot];
    const Index node = nodes.nodes().vertex[slot];
    if (range.node == node) continue;
    vacate(slot, vertices);
    range.node = node;
    range.size = 0;
    Index size = 0;
    base_->for_each_vertex(node, [&](Index) { ++size; });
    if (size <= range.room) continue;
    range.begin = static_cast<Index>(vertex_.size());
    range.room = size;
    vertex_.resize(vertex_.size() + size);
    foot_.resize(vertex_.size());
  }
  vertices.reserve(static_cast<Index>(vertex_.size()));
}

/// Computes the foot points of a cluster's vertices, once per stroke: vertices do not move while it is drawn.
void ChartTransfer::find_feet(const BasePatch& patch, Range& range) {
  base_->for_each_vertex(range.node, [&](Index vertex) {
    const Index slot = range.begin + range.size++;
    vertex_[slot] = vertex;
    foot_[slot] = patch.foot(surface_->positions[vertex]);
  });
}

/// Computes the frames of the vertices of one node's cluster.
void ChartTransfer::transfer(const Event& event, Index slot, Transferred& transferred) {
  Range& range = ranges_[slot];
  const BasePatch patch = base_->patch(range.node);
  if (range.size == 0) find_feet(patch, range);
  range.last_t = nowhere;
  contest_.find_rivals(event.nodes, slot, transferred.rivals);
  if (!transferred.rivals.empty()) return transfer_contested(event, slot, patch, transferred);
  const ChartFrame of_node = event.nodes.nodes().frame(slot);
  const DistanceRay ray = event.on_base.path.ray(of_node.t, static_cast<double>(of_node.d));
  const CoordinatePatch coordinates(patch, of_node, ray);
  const std::span feet(foot_.data() + range.begin, range.size);
  coordinates.for_each_frame(feet, [&](std::size_t i, const ChartFrame& frame) {
    range.last_t = std::max(range.last_t, frame.t);
    write(event, range.begin + static_cast<Index>(i), frame, patch, transferred);
  });
}

/// Computes the frames of a contested cluster: each vertex takes that of the rival that places it nearest to
/// the stroke, mended where it contradicts the straight line to the stroke.
void ChartTransfer::transfer_contested(const Event& event, Index slot, const BasePatch& patch,
                                       Transferred& transferred) {
  Range& range = ranges_[slot];
  const StrokePath& path = event.on_base.path;
  for (Index at = range.begin; at < range.begin + range.size; ++at) {
    const GroundVertex vertex{patch.point_at(foot_[at]), patch.normal_at(foot_[at]), patch.gauss_curvature()};
    ChartFrame nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Index rival : transferred.rivals) {
      const ChartFrame told = contest_.extrapolate(event.nodes, path, rival, vertex);
      const double distance = path.distance(told.t, static_cast<double>(told.d), vertex.position);
      range.last_t = std::max(range.last_t, told.t + StrokeSamples::most_spacing(stroke_.radius));
      if (distance >= least) continue;
      least = distance;
      nearest = told;
    }
    const MendedFrame mended = mended_frame(event.on_base, vertex, nearest);
    range.last_t = std::max(range.last_t, mended.depends_to);
    write(event, at, mended.frame, patch, transferred);
  }
}

/// Records the new frame of a slot's vertex, or that the vertex left the stroke.
void ChartTransfer::write(const Event& event, Index at, const ChartFrame& frame, const BasePatch& patch,
                          Transferred& transferred) {
  if (!within(frame, event.curve)) {
    if (!event.vertices.vacant(at)) transferred.gone.push_back(at);
  } else if (!event.vertices.rewrite(at, frame, transferred.rewritten)) {
    transferred.others.push_back({at, frame, patch.normal_at(foot_[at])});
  }
}

bool ChartTransfer::within(const ChartFrame& frame, const SurfaceCurve& curve) const {
  const double beyond = beyond_ends(frame.t, length_, false);
  if (beyond > 0 && stroke_.cap == Cap::butt) return false;
  const double width = uniform_ ? 1 : static_cast<double>(point_at(curve, frame.t).width);
  const double half_width = stroke_.radius * width, d = static_cast<double>(frame.d);
  return beyond * beyond + d * d <= half_width * half_width;
}

void ChartTransfer::vacate(Index slot, LiveChart& vertices) {
  for (Index i = 0; i < ranges_[slot].size; ++i) vertices.remove(ranges_[slot].begin + i);
  ranges_[slot].last_t = nowhere;
}

}  // namespace burin
