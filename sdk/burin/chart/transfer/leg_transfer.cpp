// Interpolates the charts of legs from base nodes to vertices and joins them. An event costs O(1) per node of
// the legs to find what changed, and O(n^2) per vertex of a changed cluster with n nodes.
#include <burin/base/parallel.h>
#include <burin/chart/transfer/coordinate_patch.h>
#include <burin/chart/transfer/leg_transfer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// The nodes of the first node's vertex.
std::span<const LegNode> first_vertex(std::span<const LegNode> nodes) {
  if (nodes.empty()) return nodes;
  const auto last =
      std::ranges::find_if(nodes, [&](const LegNode& node) { return node.vertex != nodes.front().vertex; });
  return nodes.first(static_cast<std::size_t>(last - nodes.begin()));
}

/// The frames at points of the patch of a node's base node, extrapolated from the node.
std::vector<ChartFrame> extrapolated(const BasePatch& patch, const LegNode& node,
                                     std::span<const BasePatch::Local<float>> points) {
  const CoordinatePatch coordinates(patch, node.frame, node.ray);
  CoordinatePatch::Feet feet{CoordinatePatch::Lanes::Zero(), CoordinatePatch::Lanes::Zero()};
  std::vector<ChartFrame> frames;
  frames.reserve(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += CoordinatePatch::lanes) {
    const auto count = static_cast<int>(std::min<std::size_t>(CoordinatePatch::lanes, points.size() - begin));
    for (int lane = 0; lane < count; ++lane) {
      feet.x[lane] = points[begin + static_cast<std::size_t>(lane)].x;
      feet.y[lane] = points[begin + static_cast<std::size_t>(lane)].y;
    }
    const CoordinatePatch::Frames at_feet = coordinates.at(feet);
    for (int lane = 0; lane < count; ++lane) frames.push_back(coordinates.frame(at_feet, feet, lane));
  }
  return frames;
}

bool charted_alike(std::span<const LegNode> a, std::span<const LegNode> b) {
  return std::ranges::equal(a, b, [](const LegNode& x, const LegNode& y) { return x.charted_as(y); });
}

}  // namespace

void LegTransfer::update(GroundChartBuilder::Legs legs, const SurfaceCurve& curve,
                         const ChartOptions& options, LiveChart& vertices) {
  // Which arc lengths joins computed anew is not known, but for all of them.
  constexpr double all = -std::numeric_limits<double>::infinity();
  const bool whole = !(legs.same_below > 0);
  vertices.begin_event(curve.length(), curve.closed, whole ? all : -all);
  for (; unused_ > 0; --unused_) vertices.remove(unused_ - 1);
  const std::vector<LegNode> before = std::exchange(nodes_, std::move(legs.nodes));
  // The vertices of a cluster lie less than a radius before or after its node.
  const std::vector<Nodes> stale =
      find_stale(before, nodes_, whole ? all : legs.same_below - options.radius, vertices);
  for (const Nodes& of_node : stale) make_room(of_node, vertices);
  vertices.reserve(slots_);
  const VertexJoin join(legs.stroke, curve, options);
  std::vector<std::vector<Result>> results(stale.size());
  constexpr std::size_t nodes_per_block = 16;
  parallel_blocks(stale.size(), nodes_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) results[i] = joined(stale[i], join);
  });
  for (const std::vector<Result>& of_node : results)
    for (const auto& [slot, vertex, frame, normal, filled] : of_node)
      filled ? vertices.set(slot, vertex, frame, normal) : vertices.remove(slot);
}

/// The nodes of each base node whose nodes changed, or that joins at or beyond the arc length `same_below`
/// influence. Vacates the slots of base nodes that have no nodes any more.
std::vector<LegTransfer::Nodes> LegTransfer::find_stale(Nodes before, Nodes now, double same_below,
                                                        LiveChart& vertices) {
  std::vector<Nodes> stale;
  while (!before.empty() || !now.empty()) {
    Nodes old_nodes = first_vertex(before), new_nodes = first_vertex(now);
    if (!before.empty() && !now.empty() && before.front().vertex != now.front().vertex)
      (before.front().vertex < now.front().vertex ? new_nodes : old_nodes) = {};
    before = before.subspan(old_nodes.size());
    now = now.subspan(new_nodes.size());
    const bool near =
        std::ranges::any_of(new_nodes, [&](const LegNode& n) { return n.frame.t >= same_below; });
    if (new_nodes.empty())
      vacate(ranges_[local_.find(old_nodes.front().vertex)], vertices);
    else if (near || !charted_alike(old_nodes, new_nodes))
      stale.push_back(new_nodes);
  }
  return stale;
}

/// Reserves slots of the vertices' chart for the cluster of a base node that has these nodes.
void LegTransfer::make_room(Nodes of_node, LiveChart& vertices) {
  const Index node = of_node.front().vertex, sheets = static_cast<Index>(of_node.size());
  Index local = local_.find(node);
  if (local == no_index) {
    local = local_.insert(node);
    ranges_.emplace_back();
    base_->for_each_vertex(node, [&](Index) { ++ranges_.back().vertices; });
  }
  Range& range = ranges_[local];
  if (sheets <= range.sheets) return;
  vacate(range, vertices);
  range.begin = slots_;
  range.sheets = sheets;
  slots_ += range.size();
}

void LegTransfer::vacate(const Range& range, LiveChart& vertices) {
  for (Index i = 0; i < range.size(); ++i) vertices.remove(range.begin + i);
}

/// What the slots of the cluster of one base node hold.
std::vector<LegTransfer::Result> LegTransfer::joined(Nodes of_node, const VertexJoin& join) const {
  const Index node = of_node.front().vertex;
  const Range& range = ranges_[local_.find(node)];
  const BasePatch patch = base_->patch(node);
  std::vector<Index> cluster;
  std::vector<BasePatch::Local<float>> feet;
  base_->for_each_vertex(node, [&](Index vertex) {
    cluster.push_back(vertex);
    feet.push_back(patch.foot(surface_->positions[vertex]));
  });
  std::vector<std::vector<ChartFrame>> frames;  // [node of the cluster][vertex of the cluster]
  for (const LegNode& of_leg : of_node) frames.push_back(extrapolated(patch, of_leg, feet));
  std::vector<Result> results;
  results.reserve(range.size());
  std::vector<LegNode> of_vertex;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    of_vertex.assign(of_node.begin(), of_node.end());
    for (std::size_t sheet = 0; sheet < of_vertex.size(); ++sheet) of_vertex[sheet].frame = frames[sheet][i];
    const Vec3f normal = patch.normal_at(feet[i]);
    join.join(of_vertex, normal);
    for (Index sheet = 0; sheet < range.sheets; ++sheet) {
      const Index slot = range.begin + static_cast<Index>(results.size());
      const bool filled = sheet < of_vertex.size();
      results.push_back({slot, cluster[i], filled ? of_vertex[sheet].frame : ChartFrame{}, normal, filled});
    }
  }
  return results;
}

}  // namespace burin
