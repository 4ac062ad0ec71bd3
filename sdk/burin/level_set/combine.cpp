// Set operations of distances: the union is their least, and the difference and the intersection are unions
// of complements. The fillet of radius r is what a ball of that radius outside of both cannot reach where it
// touches both; see rolling_ball.h.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/level_set/combine.h>
#include <burin/level_set/grid/rolling_ball.h>
#include <fmt/format.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

namespace burin {
namespace {

using Tree = Grid::TreeType;
using Leaf = Tree::LeafNodeType;
using Leaves = openvdb::tree::LeafManager<Tree>;

/// How far distances matter on the inner and the outer side of a surface, object units.
struct Band {
  double inside, outside;
};

/// Fills a cube of a leaf's voxels: at once where it is farther from the surface than the band.
class LeafFiller {
 public:
  /// `sides`: values whose sign tells the inner side away from the surface, or null. Where a solid is thinner
  /// than its voxels its triangles are crumpled, and their normals tell the wrong side.
  LeafFiller(Leaf& leaf, const SurfaceDistance& distance, const Grid* sides, double voxel, const Band& band)
      : leaf_(&leaf), distance_(&distance), sides_(sides), voxel_(voxel), band_(band) {
    const openvdb::Coord& origin = leaf.origin();
    origin_ = Vec3d(origin.x(), origin.y(), origin.z());
  }

  void fill() { fill(Eigen::Vector3i::Zero(), Leaf::DIM, nullptr, no_index); }

 private:
  /// `near`: the triangles that may be closest to a voxel of the cube, or null where they are too many.
  /// `triangle`: see SurfaceDistance.
  void fill(const Eigen::Vector3i& low, int side, const NearTriangles* near, Index triangle) {
    const Vec3d middle = origin_ + low.cast<double>() + Vec3d::Constant((side - 1) / 2.), p = voxel_ * middle;
    const double distance = near ? (*distance_)(p, *near, triangle) : (*distance_)(p, triangle),
                 value = on_its_side(middle, distance), radius = std::sqrt(3.) * (side - 1) / 2 * voxel_;
    if (side == 1 || value > band_.outside + radius || value < -band_.inside - radius)
      return set(low, side, value);
    const std::optional<NearTriangles> found = triangles_near(p, distance, radius, side, near);
    const int half = side / 2;
    for (int i = 0; i < 8; ++i)
      fill(low + half * Eigen::Vector3i(i >> 2, i >> 1 & 1, i & 1), half, found ? &*found : nullptr,
           triangle);
  }

  /// Those that may be closest to a voxel of a cube around p; nothing where a tree finds them in less time.
  std::optional<NearTriangles> triangles_near(const Vec3d& p, double distance, double radius, int side,
                                              const NearTriangles* larger) const {
    constexpr std::size_t most_a_voxel = 8;
    if (larger) return SurfaceDistance::around(*larger, p, distance, radius);
    return distance_->around(p, distance, radius,
                             most_a_voxel * static_cast<std::size_t>(side * side * side));
  }

  /// A distance at a point, voxels, with the right sign.
  double on_its_side(const Vec3d& point, double value) const {
    constexpr double near = 2;  // voxels
    if (!sides_ || std::abs(value) < near * voxel_) return value;
    const openvdb::Coord voxel = openvdb::Coord::round(openvdb::Vec3d(point.x(), point.y(), point.z()));
    return std::copysign(value, static_cast<double>(sides_->tree().getValue(voxel)));
  }

  void set(const Eigen::Vector3i& low, int side, double value) {
    const auto clamped = static_cast<float>(std::clamp(value, -band_.inside, band_.outside));
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        for (int k = 0; k < side; ++k)
          leaf_->setValueOn(static_cast<openvdb::Index>(((low.x() + i) * 8 + low.y() + j) * 8 + low.z() + k),
                            clamped);
  }

  Leaf* leaf_;
  const SurfaceDistance* distance_;
  const Grid* sides_;
  double voxel_;
  Band band_;
  Vec3d origin_;  ///< voxels
};

/// Calls visit(leaf) for all leaves of a grid on all threads.
template <class Visit>
void for_each_leaf(Grid& grid, const Visit& visit) {
  Leaves leaves(grid.tree());
  parallel_blocks(leaves.leafCount(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) visit(leaves.leaf(i));
  });
}

/// Throws Error where as many leaves would take more memory than a solid may.
void check_memory(double leaves) {
  constexpr double grids = 5, mega = 1e6;
  const double bytes = leaves * grids * sizeof(float) * Leaf::SIZE,
               most = static_cast<double>(SolidExtent{}.most_bytes);
  if (bytes > most)
    throw Error(
        fmt::format("merging the solid would take {:.0f} MB or more, which is above the bound of {:.0f} "
                    "MB: use larger voxels or a smaller blend",
                    bytes / mega, most / mega));
}

/// The origins of all leaves that may be as near to the solid as `reach` voxels, ascending.
std::vector<openvdb::Coord> leaves_near(const StrokeSolid& solid, double reach) {
  const int rings = static_cast<int>(std::ceil((reach + VoxelBlock::half_width) / VoxelBlock::side));
  // At least those around one block; and no list of all neighbours that is longer than the grids themselves.
  const double side = 2. * rings + 1, blocks = static_cast<double>(solid.blocks().size());
  check_memory(side * side * side * std::max(1., blocks / 800));
  std::vector<openvdb::Coord> origins;
  for (const VoxelBlock& block : solid.blocks())
    for (int i = -rings; i <= rings; ++i)
      for (int j = -rings; j <= rings; ++j)
        for (int k = -rings; k <= rings; ++k) {
          const Eigen::Vector3i at = block.origin + VoxelBlock::side * Eigen::Vector3i(i, j, k);
          origins.emplace_back(at.x(), at.y(), at.z());
        }
  parallel_sort(origins.begin(), origins.end());
  origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
  check_memory(static_cast<double>(origins.size()));
  return origins;
}

/// Distances in these leaves, as far as the band; outside everywhere else. `sides`: see LeafFiller.
Grid::Ptr filled(const std::vector<openvdb::Coord>& origins, const SurfaceDistance& distance,
                 const Grid* sides, double voxel, const Band& band, const Progress& progress) {
  const Grid::Ptr grid = empty_grid(voxel, band.outside / voxel);
  for (const openvdb::Coord& origin : origins)
    grid->tree().addLeaf(new Leaf(origin, grid->background(), true));
  constexpr std::size_t part = 1024;
  Leaves leaves(grid->tree());
  for (std::size_t from = 0; from < leaves.leafCount(); from += part) {
    report(progress, "comparing distances",
           static_cast<double>(from) / static_cast<double>(leaves.leafCount()));
    parallel_blocks(std::min(part, leaves.leafCount() - from), 1, [&](std::size_t i, std::size_t) {
      LeafFiller(leaves.leaf(from + i), distance, sides, voxel, band).fill();
    });
  }
  return grid;
}

/// Without leaves that are farther outside than the band.
void drop_far_leaves(Grid& grid) {
  std::vector<openvdb::Coord> far;
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    const float* values = leaf->buffer().data();
    if (std::all_of(values, values + Leaf::SIZE, [&](float value) { return value >= grid.background(); }))
      far.push_back(leaf->origin());
  }
  for (const openvdb::Coord& origin : far) grid.tree().addTile(1, origin, grid.background(), false);
}

std::vector<openvdb::Coord> origins_of(const Grid& grid) {
  std::vector<openvdb::Coord> origins;
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) origins.push_back(leaf->origin());
  return origins;
}

/// Calls change(value, others...) for all voxels of a grid, with the values of others of the same leaves.
template <class Change, class... Others>
void change_values(Grid& grid, const Change& change, const Others&... others) {
  for_each_leaf(grid, [&](Leaf& leaf) {
    const auto values = [&](openvdb::Index i) {
      return change(leaf.getValue(i), others.tree().probeConstLeaf(leaf.origin())->getValue(i)...);
    };
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i) leaf.setValueOn(i, values(i));
  });
}

/// The surface's distances with the sign by which the operation is a union.
float base_sign(SolidOperation operation) { return operation == SolidOperation::unite ? 1.0F : -1.0F; }
float solid_sign(SolidOperation operation) {
  return operation == SolidOperation::intersection ? -1.0F : 1.0F;
}

/// The value of the solid farthest from it at which the result differs from the surface, near that.
double farthest_contact(const Combined& combined, float sign) {
  const double voxel = combined.result->voxelSize().x();
  const auto near = static_cast<float>(voxel), differs = static_cast<float>(0.02 * voxel);
  std::atomic<float> farthest = 0;
  Grid& result = *combined.result;
  for_each_leaf(result, [&](Leaf& leaf) {
    const Leaf &surface = *combined.base->tree().probeConstLeaf(leaf.origin()),
               &solid = *combined.solid->tree().probeConstLeaf(leaf.origin());
    float most = 0;
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i)
      if (std::abs(surface.getValue(i)) < near && std::abs(leaf.getValue(i) - surface.getValue(i)) > differs)
        most = std::max(most, sign * solid.getValue(i));
    float before = farthest;
    while (before < most && !farthest.compare_exchange_weak(before, most)) {
    }
  });
  return static_cast<double>(farthest.load());
}

}  // namespace

Combined combine(const Operands& operands) {
  const double voxel = operands.voxels.voxel(), reach = 2 * std::max(operands.blend, voxel) + 4 * voxel;
  Combined combined;
  const float of_base = base_sign(operands.operation), of_solid = solid_sign(operands.operation);
  // A fillet needs distances on the side that is outside of the union.
  const double near = 3 * voxel;
  const Band beyond{near, reach}, within{reach, near};
  combined.solid =
      filled(leaves_near(operands.voxels, reach / voxel), operands.solid, grid_of(operands.voxels).get(),
             voxel, of_solid > 0 ? beyond : Band{reach, reach}, operands.progress);
  drop_far_leaves(*combined.solid);
  combined.base = filled(origins_of(*combined.solid), operands.base, nullptr, voxel,
                         of_base > 0 ? beyond : within, operands.progress);

  const Grid::Ptr first = combined.base->deepCopy(), second = combined.solid->deepCopy();
  change_values(*first, [&](float value) { return of_base * value; });
  change_values(*second, [&](float value) { return of_solid * value; });
  combined.result = first->deepCopy();
  change_values(
      *combined.result, [](float a, float b) { return std::min(a, b); }, *second);
  add_fillet(*combined.result, *first, *second, operands.blend);
  change_values(*combined.result, [&](float value) { return of_base * value; });
  combined.bytes = combined.base->memUsage() + first->memUsage() + second->memUsage() +
                   combined.solid->memUsage() + combined.result->memUsage();
  combined.contact = farthest_contact(combined, of_solid);
  return combined;
}

void fill_balls(Combined& combined, SolidOperation operation, std::span<const Vec3d> middles, double radius) {
  const double voxel = combined.result->voxelSize().x();
  const float of_base = base_sign(operation);
  const int reach = static_cast<int>(std::ceil(radius / voxel)) + 2;
  auto result = combined.result->getAccessor();
  for (const Vec3d& middle : middles) {
    const Vec3d at = middle / voxel;
    const openvdb::Coord nearest = openvdb::Coord::round(openvdb::Vec3d(at.x(), at.y(), at.z()));
    const openvdb::CoordBBox box(nearest.offsetBy(-reach), nearest.offsetBy(reach));
    for (const openvdb::Coord& place : box) {
      if (!result.isValueOn(place)) continue;
      const double far = (voxel * Vec3d(place.x(), place.y(), place.z()) - middle).norm() - radius;
      const float value = of_base * result.getValue(place);
      result.setValue(place, of_base * std::min(value, static_cast<float>(far)));
    }
  }
  combined.contact = farthest_contact(combined, solid_sign(operation));
}

}  // namespace burin
