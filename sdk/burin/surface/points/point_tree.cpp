// Wraps the kd-tree of nanoflann. The results of nearest() are sorted by distance, then by index.
#include <burin/surface/points/point_tree.h>

#include <algorithm>
#include <nanoflann.hpp>
#include <utility>

namespace burin {
namespace {

/// The interface to a set of points that nanoflann requires.
struct Points {
  std::span<const Vec3f> positions;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(Index point, std::size_t axis) const {
    return positions[point][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3, Index>;

constexpr float least_cosine = -0.5F;

}  // namespace

struct PointTree::Tree {
  explicit Tree(std::span<const Vec3f> positions) : points{positions}, index(3, points) {}

  Points points;
  KdTree index;
};

PointTree::PointTree(std::span<const Vec3f> points) : tree_(std::make_unique<Tree>(points)) {}
PointTree::~PointTree() = default;
PointTree::PointTree(PointTree&&) noexcept = default;
PointTree& PointTree::operator=(PointTree&&) noexcept = default;

void PointTree::nearest(const Vec3d& place, std::size_t count, std::vector<Near>& found) const {
  std::vector<Index> points(count);
  std::vector<double> distances(count);
  nanoflann::KNNResultSet<double, Index> result(count);
  result.init(points.data(), distances.data());
  tree_->index.findNeighbors(result, place.data(), {});
  found.clear();
  for (std::size_t i = 0; i < result.size(); ++i) found.push_back({points[i], distances[i]});
  std::ranges::sort(found, {}, [](const Near& near) { return std::pair(near.squared_distance, near.point); });
}

void PointTree::within(const Vec3d& place, double distance, std::vector<Near>& found) const {
  std::vector<std::pair<Index, double>> points;
  nanoflann::RadiusResultSet<double, Index> result(distance * distance, points);
  tree_->index.findNeighbors(result, place.data(), {});
  found.clear();
  for (const auto& [point, squared_distance] : points) found.push_back({point, squared_distance});
}

void keep_facing(std::span<const PointTree::Near> near, std::span<const Vec3f> normals, const Vec3f& normal,
                 std::size_t count, std::vector<PointTree::Near>& facing) {
  for (const PointTree::Near& candidate : near) {
    if (facing.size() == count) return;
    if (normals[candidate.point].dot(normal) > least_cosine) facing.push_back(candidate);
  }
}

}  // namespace burin
