#include <burin/base/parallel.h>
#include <burin/chart/closed_length.h>
#include <burin/chart/coordinate_patch.h>
#include <burin/chart/curve_parts.h>
#include <burin/chart/live_carrier.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Over which coordinates are fitted, and beyond which two nodes' coordinates do not go together, spacings.
constexpr double reach_over_spacing = 2, apart_over_spacing = 1;

bool same_width(const SurfaceCurve& curve) {
  return std::ranges::all_of(curve.points, [](const CurvePoint& point) { return point.width == 1; });
}

/// Calls visit(vertex) for the vertices within two edges of one, itself included; for some twice.
template <class Visit>
void for_each_within_two(const Csr& neighbours, Index vertex, const Visit& visit) {
  visit(vertex);
  for (const Index one : neighbours[vertex]) {
    visit(one);
    for (const Index two : neighbours[one]) visit(two);
  }
}

CoordinatePatch::Told told_by(const Chart& chart, Index slot, const Surface& nodes) {
  return {nodes.positions[chart.vertex[slot]], chart.t[slot], chart.d[slot]};
}

/// What the node's frame makes of a place near it: how far its coordinates are from those of another node.
double misfit(const Chart& chart, Index slot, Index other, const Vec3f& way, const Vec3f& normal) {
  const Vec3f& e1 = chart.e1[slot];
  const double t = chart.t[slot] + static_cast<double>(way.dot(e1) / chart.stretch[slot]);
  const double d = static_cast<double>(chart.d[slot] + way.dot(normal.cross(e1)));
  const double dt = chart.t[other] - t, dd = static_cast<double>(chart.d[other]) - d;
  return std::sqrt(dt * dt + dd * dd);
}

/// The node itself, and of each vertex near it the node that goes with it best, if one does.
std::vector<CoordinatePatch::Told> told_around(const BaseSurface& base, const LiveChart& nodes, Index slot) {
  const Chart& chart = nodes.nodes();
  const Index own = chart.vertex[slot];
  const BasePatch& patch = base.patch(own);
  std::vector<Index> vertices;
  for_each_within_two(base.nodes().neighbours, own, [&](Index vertex) { vertices.push_back(vertex); });
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<CoordinatePatch::Told> told{told_by(chart, slot, base.nodes())};
  for (const Index vertex : vertices) {
    if (vertex == own) continue;
    double least = apart_over_spacing * base.spacing();
    Index best = no_index;
    for (Index other = nodes.first(vertex); other != no_index; other = nodes.next(other)) {
      const Vec3f way = base.nodes().positions[vertex] - patch.position;
      const double apart = misfit(chart, slot, other, way, patch.normal);
      if (apart >= least) continue;
      least = apart;
      best = other;
    }
    if (best != no_index) told.push_back(told_by(chart, best, base.nodes()));
  }
  return told;
}

}  // namespace

const SurfaceCurve& LiveCarrier::widened(const SurfaceCurve& curve) {
  if (same_width(curve)) return curve;
  widened_ = curve;
  const double margin = stroke_.base_radius - stroke_.radius;
  for (CurvePoint& point : widened_.points)
    point.width = static_cast<float>((stroke_.radius * static_cast<double>(point.width) + margin) /
                                     stroke_.base_radius);
  return widened_;
}

void LiveCarrier::update(const LiveChart& nodes, const SurfaceCurve& curve, LiveChart& vertices) {
  // Coordinates of vertices differ from those of their nodes by less than a few spacings.
  vertices.begin_event(nodes.nodes().length, nodes.nodes().closed,
                       nodes.computed_from() + 4 * base_->spacing());
  uniform_ = same_width(curve);
  ranges_.resize(std::max(ranges_.size(), nodes.nodes().size()));
  for (const Index slot : nodes.removed())
    if (nodes.vacant(slot)) vacate(slot, vertices);
  find_dirty(nodes);
  constexpr std::size_t slots_a_block = 32;
  std::vector<std::vector<Carried>> carried((dirty_.size() + slots_a_block - 1) / slots_a_block);
  std::vector<std::size_t> ends(dirty_.size());
  parallel_blocks(dirty_.size(), slots_a_block, [&](std::size_t begin, std::size_t end) {
    std::vector<Carried>& out = carried[begin / slots_a_block];
    for (std::size_t i = begin; i < end; ++i) {
      carry(nodes, dirty_[i], curve, out);
      ends[i] = out.size();
    }
  });
  for (std::size_t i = 0; i < dirty_.size(); ++i) {
    const std::vector<Carried>& block = carried[i / slots_a_block];
    const std::size_t begin = i % slots_a_block == 0 ? 0 : ends[i - 1];
    place(dirty_[i], base_->vertex_count_of(nodes.nodes().vertex[dirty_[i]]),
          std::span(block).subspan(begin, ends[i] - begin), vertices);
  }
}

/// Lists the nodes that were computed and those that look at one that was, or that is no longer there.
void LiveCarrier::find_dirty(const LiveChart& nodes) {
  ++event_;
  dirty_.clear();
  const auto add = [&](Index vertex) {
    if (dirty_in_[vertex] == event_) return;
    dirty_in_[vertex] = event_;
    for (Index slot = nodes.first(vertex); slot != no_index; slot = nodes.next(slot)) dirty_.push_back(slot);
  };
  const Csr& neighbours = base_->nodes().neighbours;
  for (const Index vertex : nodes.altered()) for_each_within_two(neighbours, vertex, add);
  for (const Index slot : nodes.computed()) add(nodes.nodes().vertex[slot]);
}

void LiveCarrier::carry(const LiveChart& nodes, Index slot, const SurfaceCurve& curve,
                        std::vector<Carried>& out) const {
  const Index node = nodes.nodes().vertex[slot];
  const BasePatch& patch = base_->patch(node);
  const CoordinatePatch coordinates(patch, nodes.nodes().frame(slot), told_around(*base_, nodes, slot),
                                    reach_over_spacing * base_->spacing());
  Index place = 0;
  base_->for_each_vertex(node, [&](Index vertex) {
    const Vec2f at = patch.foot(surface_->positions[vertex]);
    ChartFrame frame = coordinates.frame_at(patch, at);
    if (nodes.nodes().closed) frame.t = wrapped_t(frame.t, nodes.nodes().length);
    if (within(frame, curve)) out.push_back({place, vertex, frame, patch.normal_at(at)});
    ++place;
  });
}

bool LiveCarrier::within(const ChartFrame& frame, const SurfaceCurve& curve) const {
  const double length = curve.length();
  const double beyond = curve.closed ? 0 : std::max({-frame.t, frame.t - length, 0.});
  if (beyond > 0 && stroke_.cap == Cap::butt) return false;
  const double width = uniform_ ? 1 : static_cast<double>(point_at(curve, frame.t).width);
  const double half_width = stroke_.radius * width, d = static_cast<double>(frame.d);
  return beyond * beyond + d * d <= half_width * half_width;
}

/// Gives the cluster's vertices their slots, of which it keeps as many as it has vertices.
void LiveCarrier::place(Index slot, Index cluster_size, std::span<const Carried> carried,
                        LiveChart& vertices) {
  Range& range = ranges_[slot];
  if (range.size < cluster_size) {
    vacate(slot, vertices);
    range = {slots_, cluster_size};
    slots_ += cluster_size;
  }
  auto next = carried.begin();
  for (Index i = 0; i < range.size; ++i) {
    if (next != carried.end() && next->place == i) {
      vertices.set(range.begin + i, next->vertex, next->frame, next->normal);
      ++next;
    } else {
      vertices.remove(range.begin + i);
    }
  }
}

void LiveCarrier::vacate(Index slot, LiveChart& vertices) {
  for (Index i = 0; i < ranges_[slot].size; ++i) vertices.remove(ranges_[slot].begin + i);
}

}  // namespace burin
