// Fills the voxels around a stroke with the distance to a brush's solid. Each block of voxels looks for the
// feet of its voxels in the prisms that reach into it, and asks for the distances at all of them at once; of
// several feet the nearest solid counts, which is the union.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/math/elementary.h>
#include <burin/volume/shell_blocks.h>
#include <burin/volume/solid.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>

namespace burin {
namespace {

/// Distance of a foot from the stroke in the base surface.
double distance_to_stroke(double t, double d, const Chart& chart) {
  if (chart.closed || (t >= 0 && t <= chart.length)) return std::abs(d);
  return math::hypot(t < 0 ? t : t - chart.length, d);
}

constexpr int side = VoxelBlock::side;

/// A voxel of a block.
struct Voxel {
  int i, j, k;
  std::size_t number() const { return static_cast<std::size_t>((i * side + j) * side + k); }
};

/// Its corners and its middle. No voxel of the block is farther from all of them than this, in voxels, nor
/// from any of them than its diagonal.
constexpr std::array<Voxel, 9> scattered = {{{0, 0, 0},
                                             {0, 0, side - 1},
                                             {0, side - 1, 0},
                                             {0, side - 1, side - 1},
                                             {side - 1, 0, 0},
                                             {side - 1, 0, side - 1},
                                             {side - 1, side - 1, 0},
                                             {side - 1, side - 1, side - 1},
                                             {side / 2, side / 2, side / 2}}};
constexpr double from_scattered = 4.6;
constexpr double diagonal = 12.2;

/// Computes one block after another, keeping its buffers.
class BlockFiller {
 public:
  BlockFiller(const Chart& chart, std::span<const Prism> prisms, const SolidExtent& extent,
              const DistanceToSolid& distance)
      : chart_(&chart),
        prisms_(prisms),
        extent_(&extent),
        distance_(&distance),
        h_min_(extent.h_min - VoxelBlock::half_width * extent.voxel),
        h_max_(extent.h_max + VoxelBlock::half_width * extent.voxel) {}

  VoxelBlock fill(const Eigen::Vector3i& origin, std::span<const Index> prisms) {
    origin_ = origin;
    VoxelBlock block;
    block.origin = origin;
    block.values.fill(nowhere);
    if (!is_far(prisms)) {
      start();
      for (const Index prism : prisms) add_voxels_of(prisms_[prism]);
      find_distances(block.values);
    }
    const auto band = static_cast<float>(VoxelBlock::half_width * extent_->voxel);
    for (float& value : block.values) value = std::clamp(value, -band, band);
    return block;
  }

 private:
  static constexpr float nowhere = std::numeric_limits<float>::max();

  /// Whether no voxel of the block is in the solid or its band, by what the distance is at a few of them:
  /// over one voxel it changes by one voxel at most, or more where the stroke's coordinates are dense.
  bool is_far(std::span<const Index> prisms) {
    start();
    float least_stretch = 1;
    for (const Index number : prisms) {
      const Prism& prism = prisms_[number];
      for (const Index node : prism.nodes()) least_stretch = std::min(least_stretch, chart_->stretch[node]);
      const Eigen::AlignedBox3d box = prism.box(h_min_, h_max_);
      for (const Voxel& voxel : scattered)
        if (box.contains(middle(voxel))) add(prism, voxel);
    }
    std::array<float, VoxelBlock::voxels> values;
    values.fill(nowhere);
    find_distances(values);
    float least = nowhere;
    bool all = true;
    for (const Voxel& voxel : scattered) {
      least = std::min(least, values[voxel.number()]);
      all = all && values[voxel.number()] < nowhere;
    }
    constexpr double curved = 1.5;
    const double way = curved / static_cast<double>(least_stretch) * (all ? from_scattered : diagonal);
    const double far = (way + VoxelBlock::half_width) * extent_->voxel;
    return least != nowhere && static_cast<double>(least) > far;
  }

  void start() {
    points_.clear();
    voxels_.clear();
  }

  Vec3d middle(const Voxel& voxel) const {
    return extent_->voxel * (origin_ + Eigen::Vector3i(voxel.i, voxel.j, voxel.k)).cast<double>();
  }

  /// Layer by layer: a prism that leans has a wide box, of which it fills little.
  void add_voxels_of(const Prism& prism) {
    const int axis = prism.axis();
    const Range whole = voxels_within(prism.box(h_min_, h_max_));
    for (int layer = whole.first[axis]; layer <= whole.last[axis]; ++layer) {
      const double middle = extent_->voxel * (origin_[axis] + layer), half = extent_->voxel / 2;
      Range range = voxels_within(prism.layer(h_min_, h_max_, middle - half, middle + half));
      range.first[axis] = range.last[axis] = layer;
      for (int i = range.first.x(); i <= range.last.x(); ++i)
        for (int j = range.first.y(); j <= range.last.y(); ++j)
          for (int k = range.first.z(); k <= range.last.z(); ++k) add(prism, {i, j, k});
    }
  }

  struct Range {
    Eigen::Vector3i first, last;
  };

  /// Those of the block whose middles are in the box.
  Range voxels_within(const Eigen::AlignedBox3d& box) const {
    Range range{Eigen::Vector3i::Zero(), Eigen::Vector3i::Constant(-1)};
    if (box.isEmpty()) return range;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box.min()[axis] / extent_->voxel, high = box.max()[axis] / extent_->voxel;
      range.first[axis] = std::max(0, static_cast<int>(std::ceil(low)) - origin_[axis]);
      range.last[axis] = std::min(side - 1, static_cast<int>(std::floor(high)) - origin_[axis]);
    }
    return range;
  }

  void add(const Prism& prism, const Voxel& voxel) {
    prism.find(middle(voxel), [&](ShellPoint point) {
      if (chart_->closed) point.t -= chart_->length * std::floor(point.t / chart_->length);
      points_.push_back(point);
      voxels_.push_back(voxel.number());
    });
  }

  /// Computes the distances at the points so far. A voxel gets the least of those at its points.
  void find_distances(std::span<float> values) {
    if (points_.empty()) return;
    distances_.assign(points_.size(), 0);
    (*distance_)(points_, distances_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const ShellPoint& point = points_[i];
      if (!std::isfinite(distances_[i]))
        throw Error(fmt::format("the distance at t {:.4g}, d {:.4g}, h {:.4g} is not finite", point.t,
                                static_cast<double>(point.d), static_cast<double>(point.h)));
      const auto beyond = static_cast<float>(
          distance_to_stroke(point.t, static_cast<double>(point.d), *chart_) - extent_->radius);
      float& value = values[voxels_[i]];
      value = std::min(value, std::max(distances_[i], beyond));
    }
  }

  const Chart* chart_;
  std::span<const Prism> prisms_;
  const SolidExtent* extent_;
  const DistanceToSolid* distance_;
  double h_min_, h_max_;  ///< of the solid and its band, object units
  Eigen::Vector3i origin_ = Eigen::Vector3i::Zero();
  std::vector<ShellPoint> points_;
  std::vector<std::size_t> voxels_;  ///< [point]
  std::vector<float> distances_;
};

void check(const SolidExtent& extent) {
  if (!(extent.voxel > 0 && std::isfinite(extent.voxel))) throw Error("the voxel must be above 0");
  if (!(extent.h_min < extent.h_max && std::isfinite(extent.h_min) && std::isfinite(extent.h_max)))
    throw Error(fmt::format("a solid cannot reach from h {:.4g} to {:.4g}", extent.h_min, extent.h_max));
}

/// Whether voxels of the block are in the solid or its band.
bool holds_something(const VoxelBlock& block, double voxel) {
  const auto band = static_cast<float>(VoxelBlock::half_width * voxel);
  return std::ranges::any_of(block.values, [&](float value) { return value < band; });
}

bool comes_before(const VoxelBlock& a, const VoxelBlock& b) {
  return std::ranges::lexicographical_compare(a.origin, b.origin);
}

}  // namespace

StrokeSolid::StrokeSolid(const SolidGround& ground, const SolidExtent& extent,
                         const DistanceToSolid& distance, const Progress& progress)
    : voxel_(extent.voxel) {
  check(extent);
  const std::vector<Prism> prisms = shell_over(ground);
  const double margin = VoxelBlock::half_width * extent.voxel;
  const ShellBlocks blocks(prisms, extent.h_min - margin, extent.h_max + margin, extent.voxel,
                           extent.most_bytes);
  // In parts, since most blocks are found to hold nothing and need no memory then.
  constexpr std::size_t part = 4096, grain = 16;
  for (std::size_t from = 0; from < blocks.size(); from += part) {
    report(progress, "making the solid", static_cast<double>(from) / static_cast<double>(blocks.size()));
    std::vector<VoxelBlock> filled(std::min(part, blocks.size() - from));
    std::vector<std::exception_ptr> failures(filled.size());
    parallel_blocks(filled.size(), grain, [&](std::size_t begin, std::size_t end) {
      BlockFiller filler(ground.chart, prisms, extent, distance);
      for (std::size_t i = begin; i < end; ++i) try {
          filled[i] = filler.fill(blocks.origin(from + i), blocks.prisms(from + i));
        } catch (...) {
          failures[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
      if (failure) std::rethrow_exception(failure);
    std::ranges::copy_if(filled, std::back_inserter(blocks_),
                         [&](const VoxelBlock& block) { return holds_something(block, voxel_); });
  }
}

void StrokeSolid::add(const StrokeSolid& other) {
  if (other.voxel_ != voxel_) throw ContractError("solids of different voxels");
  std::vector<VoxelBlock> both;
  std::ranges::merge(blocks_, other.blocks_, std::back_inserter(both), comes_before);
  blocks_.clear();
  for (const VoxelBlock& block : both) {
    if (blocks_.empty() || blocks_.back().origin != block.origin) {
      blocks_.push_back(block);
      continue;
    }
    auto& values = blocks_.back().values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::min(values[i], block.values[i]);
  }
}

}  // namespace burin
