// Joins the charts of legs at vertices. An event costs O(n^2) per vertex of a changed cluster with n nodes.
#include <burin/base/parallel.h>
#include <burin/chart/transfer/coordinate_patch.h>
#include <burin/chart/transfer/leg_transfer.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace {

constexpr double beyond_all = std::numeric_limits<double>::infinity(), before_all = -beyond_all;

}  // namespace

void LegTransfer::update(const LegCharts& charts, const SurfaceCurve& curve, const ChartOptions& options,
                         LiveChart& vertices) {
  // The vertices of a cluster lie less than a radius before or after its node.
  const double same_below = charts.same_below() - options.radius;
  // Joins may compute any arc length anew, and no arc length is known from which on they compute all.
  vertices.begin_event(curve.length(), curve.closed, beyond_all);
  for (; unused_ > 0; --unused_) vertices.remove(unused_ - 1);
  const std::vector<Index> stale = find_stale(charts, same_below);
  for (const Index local : stale) make_room(charts, local, vertices);
  vertices.reserve(slots_);
  const VertexJoin join(charts.stroke(), curve, options);
  std::vector<std::vector<Result>> results(stale.size());
  constexpr std::size_t nodes_per_block = 16;
  parallel_blocks(stale.size(), nodes_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) results[i] = joined(charts, stale[i], join);
  });
  for (const std::vector<Result>& of_node : results)
    for (const auto& [slot, vertex, frame, normal, filled] : of_node)
      filled ? vertices.set(slot, vertex, frame, normal) : vertices.remove(slot);
}

/// The vertices of the charts whose nodes changed, or that joins at or beyond the arc length `same_below`
/// influence, by their numbers in ascending order.
std::vector<Index> LegTransfer::find_stale(const LegCharts& charts, double same_below) {
  ranges_.resize(charts.local_count());
  last_t_.resize(charts.local_count(), before_all);
  for (const Index local : charts.changed()) {
    last_t_[local] = before_all;
    for (const LegNode& node : charts.nodes(local)) last_t_[local] = std::max(last_t_[local], node.frame.t);
  }
  const auto last_t = [this](Index local) { return last_t_[local]; };
  std::vector<Index> stale(charts.changed().begin(), charts.changed().end());
  for (const Index local : stale_.find(same_below, charts.changed(), charts.local_count(), last_t))
    if (last_t(local) >= same_below) stale.push_back(local);
  std::ranges::sort(stale);
  const auto repeated = std::ranges::unique(stale);
  stale.erase(repeated.begin(), repeated.end());
  return stale;
}

/// Reserves slots of the vertices' chart for the cluster of a node.
void LegTransfer::make_room(const LegCharts& charts, Index local, LiveChart& vertices) {
  Range& range = ranges_[local];
  if (range.vertices == 0) {
    if (base_)
      base_->for_each_vertex(charts.vertex(local), [&](Index) { ++range.vertices; });
    else
      range.vertices = 1;
  }
  const auto sheets = static_cast<Index>(charts.nodes(local).size());
  if (sheets <= range.sheets) return;
  for (Index i = 0; i < range.size(); ++i) vertices.remove(range.begin + i);
  range.begin = slots_;
  range.sheets = sheets;
  slots_ += range.size();
}

/// The vertices of the cluster of a node with the coordinates that each of its charts gives them.
std::vector<LegTransfer::OfVertex> LegTransfer::cluster(const LegCharts& charts, Index local) const {
  const std::span<const LegNode> nodes = charts.nodes(local);
  const Index at = charts.vertex(local);
  if (!base_) return {{at, surface_->normals[at], {nodes.begin(), nodes.end()}}};
  const BasePatch patch = base_->patch(at);
  std::vector<BasePatch::Local<float>> feet;
  std::vector<OfVertex> cluster;
  base_->for_each_vertex(at, [&](Index vertex) {
    feet.push_back(patch.foot(surface_->positions[vertex]));
    cluster.push_back({vertex, patch.normal_at(feet.back()), {nodes.begin(), nodes.end()}});
  });
  for (std::size_t sheet = 0; sheet < nodes.size(); ++sheet) {
    const CoordinatePatch coordinates(patch, nodes[sheet].frame, nodes[sheet].ray);
    coordinates.for_each_frame(
        feet, [&](std::size_t i, const ChartFrame& frame) { cluster[i].nodes[sheet].frame = frame; });
  }
  return cluster;
}

/// What the slots of a node's cluster hold.
std::vector<LegTransfer::Result> LegTransfer::joined(const LegCharts& charts, Index local,
                                                     const VertexJoin& join) const {
  const Range& range = ranges_[local];
  std::vector<Result> results;
  results.reserve(range.size());
  for (auto& [vertex, normal, nodes] : cluster(charts, local)) {
    join.join(nodes, normal);
    for (Index sheet = 0; sheet < range.sheets; ++sheet) {
      const Index slot = range.begin + static_cast<Index>(results.size());
      const bool filled = sheet < nodes.size();
      results.push_back({slot, vertex, filled ? nodes[sheet].frame : ChartFrame{}, normal, filled});
    }
  }
  return results;
}

}  // namespace burin
