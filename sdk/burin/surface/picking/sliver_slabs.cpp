// Bounds runs of long thin triangles by slabs, in O(n) for n triangles.
#include <burin/base/parallel.h>
#include <burin/surface/geometry/area_vector.h>
#include <burin/surface/picking/sliver_slabs.h>

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <limits>

namespace burin {
namespace {

/// The boxes of runs with less area than this share of their squared diagonals do not fit. It is about a
/// quarter for even triangles.
constexpr double least_area = 1e-3;

/// Searches look at fewer runs than this in no time, slabs or none.
constexpr std::size_t fewest_runs = 64;
constexpr std::size_t runs_per_block = 4096;

/// Slabs are wider by this share of their coordinates, so that rounding does not put a triangle outside.
constexpr double rounding = 1e-12;

std::array<Vec3d, 3> corner_positions(const Surface& surface, Index triangle) {
  const Triangle& t = surface.triangles[triangle];
  return {surface.positions[t[0]].cast<double>(), surface.positions[t[1]].cast<double>(),
          surface.positions[t[2]].cast<double>()};
}

Vec3d longest_edge(const std::array<Vec3d, 3>& corners) {
  const std::array<Vec3d, 3> edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  return *std::ranges::max_element(edges, {}, [](const Vec3d& edge) { return edge.squaredNorm(); });
}

}  // namespace

SliverSlabs::SliverSlabs(const Surface& surface, std::size_t run_length)
    : surface_(&surface), run_length_(run_length) {
  const std::size_t runs = (surface.triangles.size() + run_length - 1) / run_length;
  std::atomic<std::size_t> unfit{0};
  parallel_blocks(runs, runs_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) unfit += box_fits(run) ? 0 : 1;
  });
  if (unfit < fewest_runs) return;
  slabs_.resize(runs);
  parallel_blocks(runs, runs_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) slabs_[run] = slab_of(run);
  });
}

template <class Visit>
void SliverSlabs::for_triangles(std::size_t run, const Visit& visit) const {
  const std::size_t end = std::min((run + 1) * run_length_, surface_->triangles.size());
  for (std::size_t i = run * run_length_; i < end; ++i) visit(static_cast<Index>(i));
}

bool SliverSlabs::box_fits(std::size_t run) const {
  Eigen::AlignedBox3d box;
  double area = 0;
  for_triangles(run, [&](Index triangle) {
    for (const Vec3d& corner : corner_positions(*surface_, triangle)) box.extend(corner);
    area += area_vector(surface_->positions, surface_->triangles[triangle]).norm() / 2;
  });
  return area >= least_area * box.diagonal().squaredNorm();
}

SliverSlabs::Slab SliverSlabs::slab_of(std::size_t run) const {
  if (box_fits(run)) return {};
  const auto first = static_cast<Index>(run * run_length_);
  const Vec3d normal = area_vector(surface_->positions, surface_->triangles[first]);
  const Vec3d across = normal.cross(longest_edge(corner_positions(*surface_, first))).stableNormalized();
  double least = std::numeric_limits<double>::infinity(), most = -least, farthest = 0;
  for_triangles(run, [&](Index triangle) {
    for (const Vec3d& corner : corner_positions(*surface_, triangle)) {
      least = std::min(least, across.dot(corner));
      most = std::max(most, across.dot(corner));
      farthest = std::max(farthest, corner.cwiseAbs().maxCoeff());
    }
  });
  return {across, least - rounding * farthest, most + rounding * farthest};
}

}  // namespace burin
