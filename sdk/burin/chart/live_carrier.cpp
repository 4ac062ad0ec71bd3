#include <burin/base/parallel.h>
#include <burin/chart/closed_length.h>
#include <burin/chart/coordinate_patch.h>
#include <burin/chart/curve_parts.h>
#include <burin/chart/live_carrier.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

bool same_width(const SurfaceCurve& curve) {
  return std::ranges::all_of(curve.points, [](const CurvePoint& point) { return point.width == 1; });
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
  const std::span<const Index> slots = nodes.computed();
  constexpr std::size_t slots_a_block = 32;
  std::vector<std::vector<Carried>> carried((slots.size() + slots_a_block - 1) / slots_a_block);
  std::vector<std::size_t> ends(slots.size());
  parallel_blocks(slots.size(), slots_a_block, [&](std::size_t begin, std::size_t end) {
    std::vector<Carried>& out = carried[begin / slots_a_block];
    for (std::size_t i = begin; i < end; ++i) {
      carry(nodes, slots[i], curve, out);
      ends[i] = out.size();
    }
  });
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::vector<Carried>& block = carried[i / slots_a_block];
    const std::size_t begin = i % slots_a_block == 0 ? 0 : ends[i - 1];
    place(slots[i], base_->vertex_count_of(nodes.nodes().vertex[slots[i]]),
          std::span(block).subspan(begin, ends[i] - begin), vertices);
  }
}

void LiveCarrier::carry(const LiveChart& nodes, Index slot, const SurfaceCurve& curve,
                        std::vector<Carried>& out) const {
  const Index node = nodes.nodes().vertex[slot];
  const BasePatch& patch = base_->patch(node);
  const CoordinatePatch coordinates(patch, nodes.nodes().frame(slot));
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
