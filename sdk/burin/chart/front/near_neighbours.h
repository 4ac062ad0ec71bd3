#pragma once
#include <burin/chart/chart_ground.h>
#include <burin/surface/points/point_tree.h>

#include <cstddef>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// The neighbours of vertices, of which a vertex may have very many, as at the hub of a fan. A query costs
/// O(neighbours) up to `most_listed` of them, and O(k log n) for k of n beyond, after O(n log n) for the
/// first query of the vertex.
class NearNeighbours {
 public:
  static constexpr std::size_t most_listed = 512;

  /// The ground must outlive the object.
  explicit NearNeighbours(const ChartGround& ground) : ground_(&ground) {}

  /// Follows a change of positions.
  void restart() { crowded_.clear(); }

  /// The neighbours of a vertex, ascending; of more than `most_listed` some that are not closer to a position
  /// than `reach`, object units, may be missing. Valid until the next call.
  std::span<const Index> around(Index vertex, const Vec3d& place, double reach);

 private:
  struct Crowd {
    Crowd(const ChartGround& ground, std::span<const Index> neighbours);

    std::vector<Vec3f> positions;
    PointTree tree;  ///< over `positions`
  };

  const ChartGround* ground_;
  std::unordered_map<Index, std::unique_ptr<Crowd>> crowded_;
  std::vector<PointTree::Near> near_;
  std::vector<Index> found_;
};

}  // namespace burin
