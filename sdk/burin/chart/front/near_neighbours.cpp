// Finds the neighbours of a vertex near a place: all of them where they are few, else by a kd-tree over their
// positions. Without it a stroke near a vertex of n neighbours would cost O(n) for each of its segments.
#include <burin/chart/front/near_neighbours.h>

#include <algorithm>

namespace burin {
namespace {

std::vector<Vec3f> positions_of(const ChartGround& ground, std::span<const Index> vertices) {
  std::vector<Vec3f> positions;
  for (const Index vertex : vertices) positions.push_back(ground[vertex].position);
  return positions;
}

}  // namespace

NearNeighbours::Crowd::Crowd(const ChartGround& ground, std::span<const Index> neighbours)
    : positions(positions_of(ground, neighbours)), tree(positions) {}

std::span<const Index> NearNeighbours::around(Index vertex, const Vec3d& place, double reach) {
  const std::span<const Index> neighbours = ground_->neighbours(vertex);
  if (neighbours.size() <= most_listed) return neighbours;
  std::unique_ptr<Crowd>& crowd = crowded_[vertex];
  if (!crowd) crowd = std::make_unique<Crowd>(*ground_, neighbours);
  crowd->tree.within(place, reach, near_);
  found_.clear();
  for (const PointTree::Near& near : near_) found_.push_back(neighbours[near.point]);
  std::ranges::sort(found_);
  return found_;
}

}  // namespace burin
