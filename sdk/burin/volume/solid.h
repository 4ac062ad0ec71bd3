#pragma once
#include <burin/base/progress.h>
#include <burin/chart/chart.h>
#include <burin/stroke/stroke_choices.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace burin {

/// A point of the space around a stroke, in the stroke's coordinates.
struct ShellPoint {
  double t = 0;  ///< of its foot on the base surface, object units; of a closed stroke in
                 ///< [0, length)
  float d = 0;   ///< likewise
  float h = 0;   ///< height over the foot along the base normal, positive outside, object units
  std::array<Index, 3> nodes{};   ///< of the chart, around the foot
  Vec3f weights = Vec3f::Zero();  ///< of the nodes; they sum up to 1, and some may be below 0 at the chart's
                                  ///< rim
};

/// Writes the signed distance to a solid, negative inside, object units, at each point. Called on any thread,
/// concurrently.
using DistanceToSolid = std::function<void(std::span<const ShellPoint>, std::span<float>)>;

/// Where a solid is, and how finely it is to be made.
struct SolidExtent {
  double h_min = 0, h_max = 0;  ///< object units; the solid is empty outside of them
  double radius = 0;  ///< of the stroke, object units: the solid is cut off where the stroke is farther
  double voxel = 0;   ///< edge of a voxel, object units
  std::size_t most_bytes = std::size_t{2} << 30;  ///< that the grid may take
};

/// The surface that a chart was made of.
struct SolidGround {
  const Surface& surface;
  const Chart& chart;
  std::function<Vec3f(Index vertex)> position;  ///< on the base surface
};

/// A cube of voxels with the signed distance to a solid at their middles, object units; not below -half_width
/// and not above half_width voxels. Voxel (i, j, k), whose middle is at (i, j, k) times its edge, has the
/// number 64 i + 8 j + k within its block.
struct VoxelBlock {
  static constexpr int side = 8, voxels = side * side * side;
  static constexpr int half_width = 3;  ///< voxels, of the band in which distances are known

  Eigen::Vector3i origin = Eigen::Vector3i::Zero();  ///< its least voxel, multiples of `side`
  std::array<float, voxels> values{};                ///< [voxel]
};

/// A solid along a stroke in voxels: the union of what the distance makes of all feet that a point has on
/// the base surface, in every sheet of the stroke.
///
/// A point p lies over a triangle of the chart where p = x + h n, with x and n interpolated between the base
/// positions and normals of its corners, so that the prisms over neighbouring triangles meet without gap or
/// overlap [S. Porumbescu et al., Shell Maps, 2005]. Beyond the focal surface of the base, where prisms have
/// turned inside out, a point has no foot.
///
/// Made on all threads; the bits do not depend on their number.
class StrokeSolid {
 public:
  /// Throws Error where the extent or the voxel is none, the grid would need more than `most_bytes`, or a
  /// distance is not finite: that of the lowest block; and what `distance` and `progress` throw. Costs time
  /// and memory in proportion to the voxels near the solid's surface and within, and to the chart.
  StrokeSolid(const SolidGround& ground, const SolidExtent& extent, const DistanceToSolid& distance,
              const Progress& progress = {});

  /// Takes voxels of this edge as they are: blocks as blocks() has them.
  StrokeSolid(double voxel, std::vector<VoxelBlock> blocks) : voxel_(voxel), blocks_(std::move(blocks)) {}

  /// Adds another solid of the same voxel: afterwards this is both.
  void add(const StrokeSolid& other);

  bool empty() const { return blocks_.empty(); }  ///< whether there is none
  double voxel() const { return voxel_; }         ///< edge, object units

  /// Where the solid is and around it, ascending by x, y and z. Elsewhere there is none of it. Values are as
  /// the distance has them in the stroke's coordinates, so that only where they are 0 they mean what they say
  /// in space; see level_set/solid_mesh.h for the surface there.
  std::span<const VoxelBlock> blocks() const { return blocks_; }

 private:
  double voxel_;
  std::vector<VoxelBlock> blocks_;
};

/// By how much the distance changes over a length of 1 in space: the median over the voxels near the solid's
/// surface. 1 where it is a true distance, but for what bends and curvature stretch; 1 also for no solid.
double median_slope(const StrokeSolid& solid);

/// The solid that a closed mesh bounds, and the edge of the voxels that it is to be taken in, object units.
struct MeshSolid {
  const TriangleMesh& mesh;
  double voxel;
};

/// What is to be done with a solid and a surface. Non-owning.
struct SolidMerge {
  const Surface& surface;
  const Picker& picker;
  std::variant<std::reference_wrapper<const StrokeSolid>, MeshSolid> solid;
  SolidOperation operation = SolidOperation::unite;  ///< or difference or intersection
  double blend = 0;  ///< radius of the fillet where surface and solid meet, object units
  Progress progress = {};
};

/// Wall time of the steps of a merge, seconds.
struct MergeSeconds {
  double distances = 0;  ///< of voxels to both surfaces, and the fillet
  double contour = 0;    ///< the result's surface in these
  double join = 0;       ///< cutting both surfaces and joining them
  double remesh = 0;     ///< of the seam
};

/// What became of it.
struct MergedSolid {
  SurfacePatch patch;
  MergeSeconds seconds;
  double voxel = 0;        ///< edge, object units
  std::size_t voxels = 0;  ///< in which both were compared
  std::size_t bytes = 0;   ///< of the largest of their grids together
};

/// Does it; merge_solid() of level_set is one. Throws Error with a line that says what cannot be done.
using SolidMerger = std::function<MergedSolid(const SolidMerge&)>;

}  // namespace burin
