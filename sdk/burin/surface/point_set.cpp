// Makes surfaces of point sets: "a point sampling with neighbourhood connectivity" [R. Schmidt, Stroke
// Parameterization, 2013, section 2], here the symmetric k-nearest-neighbour graph. Costs O(n log n).
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/trees/bounding_box.h>
#include <burin/base/trees/spatial_order.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/point_set.h>
#include <burin/surface/points/point_tree.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace burin {
namespace {

constexpr std::size_t points_per_block = 1024;

void check(const PointSet& points, std::size_t links) {
  if (points.positions.size() != points.normals.size())
    throw ContractError("a point set needs a normal a point");
  if (links < 3) throw ContractError("a point needs 3 links at least");
  if (points.positions.size() < 3) throw Error("a point set needs 3 points at least");
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    if (!points.positions[i].allFinite())
      throw Error(fmt::format("point {} has a coordinate that is not finite", i + 1));
    if (!points.normals[i].allFinite() || points.normals[i].isZero(0)) {
      throw Error(fmt::format("the normal of point {} is not finite or zero", i + 1));
    }
  }
}

/// Normalises in doubles, in which the square of any non-zero float is not zero.
Vec3f unit(const Vec3f& normal) { return normal.cast<double>().normalized().cast<float>(); }

void sort_points(const PointSet& points, Surface& surface) {
  surface.source_vertex = spatial_order(points.positions);
  surface.positions.reserve(points.positions.size());
  surface.normals.reserve(points.positions.size());
  for (const Index source : surface.source_vertex) {
    surface.positions.push_back(points.positions[source]);
    surface.normals.push_back(unit(points.normals[source]));
  }
}

/// The nearest points of each point that face the same way: `links` entries per point, unused ones no_index.
std::vector<Index> nearest_facing(const Surface& surface, const PointTree& tree, std::size_t links) {
  std::vector<Index> result(surface.positions.size() * links, no_index);
  parallel_blocks(surface.positions.size(), points_per_block, [&](std::size_t begin, std::size_t end) {
    std::vector<PointTree::Near> near, facing;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(surface.positions[i].cast<double>(), 3 * links + 1, near);
      std::erase_if(near, [i](const PointTree::Near& other) { return other.point == i; });
      facing.clear();
      keep_facing(near, surface.normals, surface.normals[i], links, facing);
      for (std::size_t link = 0; link < facing.size(); ++link) result[i * links + link] = facing[link].point;
    }
  });
  return result;
}

/// Connects two points if either is among the nearest of the other.
Csr symmetric(const std::vector<Index>& nearest, std::size_t links, Index points) {
  std::vector<std::vector<Index>> rows(points);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] == no_index) continue;
    rows[i / links].push_back(nearest[i]);
    rows[nearest[i]].push_back(static_cast<Index>(i / links));
  }
  Csr graph;
  graph.offsets.push_back(0);
  for (std::vector<Index>& row : rows) {
    std::ranges::sort(row);
    row.erase(std::unique(row.begin(), row.end()), row.end());
    graph.items.insert(graph.items.end(), row.begin(), row.end());
    graph.offsets.push_back(static_cast<Index>(graph.items.size()));
  }
  return graph;
}

}  // namespace

Surface make_point_surface(const PointSet& points, std::size_t links, const Progress& progress) {
  check(points, links);
  Surface surface;
  report(progress, "sorting the points", 0);
  sort_points(points, surface);
  surface.scale = bounding_box_diagonal(surface.positions);
  report(progress, "connecting the points", 0.3);
  const PointTree tree(surface.positions);
  surface.neighbours = symmetric(nearest_facing(surface, tree, links), links, surface.vertex_count());
  surface.incident.offsets.assign(surface.positions.size() + 1, 0);
  compute_gauss_curvature(surface);
  report(progress, "connecting the points", 1);
  return surface;
}

}  // namespace burin
