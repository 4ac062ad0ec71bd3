// Joins sets of triangles through voxels. The result's distance is contoured around the solid. The
// surface is cut, and the contour too, along the line on which the solid is as far as the result differs from
// the surface and a voxel more; there both lie on the surface, and are joined. The seam is remeshed.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/stopwatch.h>
#include <burin/level_set/combine.h>
#include <burin/level_set/grid/rolling_ball.h>
#include <burin/level_set/mesh_solid.h>
#include <burin/level_set/relaxed_mesh.h>
#include <burin/level_set/replaced.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/level_set/surface_distance.h>
#include <burin/remesh/agree.h>
#include <burin/remesh/divide.h>
#include <burin/remesh/improve.h>
#include <burin/remesh/intersection.h>
#include <burin/remesh/join.h>
#include <burin/remesh/refine.h>
#include <burin/remesh/specks.h>
#include <burin/remesh/untangle.h>
#include <fmt/format.h>
#include <openvdb/tools/Interpolation.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace burin {
namespace {

/// The voxel's share by which the cut lies beyond what differs, and by which triangles are replaced beyond
/// it.
constexpr double cut_beyond = 1.2, replaced_beyond = 0.7;

/// Edges of new triangles, voxels, and how they grow away from the cut.
constexpr double edge_length = 1.2, growth = 0.7;

/// How far beyond the cut triangles are made even, voxels.
constexpr double seam_width = 2.5;

/// How far apart the lines may be along which both are cut, and how far from the cut's distance a disc may be
/// that only one of them has within such a line; voxels.
constexpr double join_within = 0.5, shallow = 0.5;

/// How far vertices may be from a crease to find it, to be brought to it, and to count as on it; voxels.
constexpr double crease_width = 1, snap = 0.3, on_crease_within = 1e-3;

/// Radius of the balls that fill what is too thin, voxels, and how often a bad result is mended: first by
/// leaving the crease round there.
constexpr double ball_radius = 1.5;
constexpr int most_mendings = 5;

Vec3d middle_of(const PatchMesh& patch, Index triangle) {
  Vec3d sum = Vec3d::Zero();
  for (const Index vertex : patch.triangles[triangle]) sum += patch.positions[vertex];
  return sum / 3;
}

/// The surface of a solid, for distances to it.
struct SolidSurface {
  explicit SolidSurface(const StrokeSolid& solid) : surface(make_surface(mesh_of(solid))), picker(surface) {}

  Surface surface;
  Picker picker;
};

class Merger {
 public:
  Merger(const SolidMerge& merge, const StrokeSolid& solid)
      : merge_(&merge),
        surface_(&merge.surface),
        voxel_(solid.voxel()),
        base_(merge.surface, merge.picker),
        solid_surface_(solid),
        solid_(solid_surface_.surface, solid_surface_.picker),
        combined_(combine({solid, solid_, base_, merge.operation, merge.blend, merge.progress})),
        surface_of_(*combined_.result),
        side_(merge.operation == SolidOperation::intersection ? -1 : 1),
        candidates_(find_candidates()) {}

  MergedSolid run() {
    seconds_.distances = watch_.lap();
    relaxed_ = contour();
    sharp_ = !(merge_->blend > 0);
    std::optional<SurfacePatch> patch = result();
    for (int mending = 0; mending < most_mendings && !bad_.empty(); ++mending) {
      mend(mending > 0 || !sharp_);
      if (std::optional<SurfacePatch> mended = result()) patch = std::move(mended);
    }
    // A crease that cannot be is left as round as the voxels make it.
    if (!patch && std::exchange(sharp_, false)) patch = result();
    if (patch)
      return {std::move(*patch), seconds_, voxel_, combined_.result->tree().leafCount() * VoxelBlock::voxels,
              combined_.bytes};
    if (!crossing_) throw Error("the solid's surface and the rest cannot be joined here: try another voxel");
    throw Error(
        fmt::format("at ({:.6g}, {:.6g}, {:.6g}) something is thinner than the voxels: try another voxel",
                    crossing_->x(), crossing_->y(), crossing_->z()));
  }

 private:
  /// Lets the crease be round where the result is bad, and fills what is too thin there.
  void mend(bool fill) {
    blunt(bad_);
    if (!fill) return;
    fill_balls(combined_, merge_->operation, bad_, ball_radius * voxel_);
    relaxed_ = contour();
  }

  void blunt(const std::vector<Vec3d>& places) {
    constexpr int reach = 3;  // voxels
    for (const Vec3d& p : places) {
      const openvdb::Coord at = voxel_at(p);
      blunt_.fill(openvdb::CoordBBox(at.offsetBy(-reach), at.offsetBy(reach)), true);
    }
  }

  openvdb::Coord voxel_at(const Vec3d& p) const {
    return openvdb::Coord::round(openvdb::Vec3d(p.x(), p.y(), p.z()) / voxel_);
  }

  TriangleMesh contour() const {
    report(merge_->progress, "contouring", 0);
    return relaxed_mesh(surface_of_);
  }

  /// The result; nothing where it cannot be made. Sets where it is bad.
  std::optional<SurfacePatch> result() {
    bad_.clear();
    crossing_.reset();
    const PatchMesh contour = contoured(relaxed_);
    seconds_.contour += watch_.lap();
    // Where the line that they are cut along nearly touches itself, the two may differ; elsewhere they do
    // not.
    constexpr int tries = 6;
    constexpr double step = 0.2;  // voxels
    for (int i = 0; i < tries; ++i) {
      report(merge_->progress, "joining", static_cast<double>(i) / tries);
      cut_ = combined_.contact + (cut_beyond + i * step) * voxel_;
      if (std::optional<SurfacePatch> patch = attempt(contour)) return patch;
      if (crossing_) break;
    }
    return {};
  }

  /// How far a point is from the solid, on the side on which the surface stays; object units.
  double beyond(const Vec3d& p) const {
    const Vec3d at = p / voxel_;
    const Grid& grid = *combined_.solid;
    return side_ * static_cast<double>(openvdb::tools::BoxSampler::sample(
                       grid.tree(), openvdb::Vec3d(at.x(), at.y(), at.z())));
  }
  double known() const { return static_cast<double>(combined_.solid->background()); }

  /// The surface of the result around the solid, brought to the surface itself where it is that.
  PatchMesh contoured(const TriangleMesh& mesh) const {
    PatchMesh patch{{}, mesh.triangles, std::vector<Index>(mesh.positions.size(), no_index)};
    for (const Vec3f& p : mesh.positions) patch.positions.push_back(p.cast<double>());
    const std::vector<Vec3d> contour = patch.positions;
    parallel_blocks(patch.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        // Where the voxels end is a wall within the surface, which is cut off.
        Vec3d& p = patch.positions[v];
        p = is_base(p) ? base_.closest(p, voxel_ / 2).value_or(p) : snapped(p);
      }
    });
    untangle(patch, contour);
    if (sharp_) sharpen(patch);
    return patch;
  }

  /// Vertices that are very near to the crease are brought to it, so that cutting along it leaves no slivers.
  Vec3d snapped(const Vec3d& p) const {
    const std::optional<Vec3d> crease = on_crease(p);
    return crease && (*crease - p).norm() < snap * voxel_ ? *crease : p;
  }

  /// Splits triangles that reach from the surface to the solid's along the line in which both meet.
  void sharpen(PatchMesh& patch) const {
    const auto side = [this](const Vec3d& p) {
      const double reach = 2 * voxel_;
      const auto a = base_.near(p, reach), b = solid_.near(p, reach);
      const double difference = (b ? std::abs(b->value) : reach) - (a ? std::abs(a->value) : reach);
      return std::abs(difference) < on_crease_within * voxel_ ? 0 : difference;
    };
    cut(patch, side, [this](const Vec3d& p) { return on_crease(p).value_or(p); });
  }

  bool is_on_crease(const Vec3d& p) const {
    const std::optional<Vec3d> crease = on_crease(p);
    return crease && (*crease - p).norm() < on_crease_within * voxel_;
  }

  /// Whether the result's surface is there that of the surface.
  bool is_base(const Vec3d& p) const { return beyond(p) > combined_.contact + 0.5 * voxel_; }

  /// The point of the line in which surface and solid meet, for one near it, where it is to be sharp.
  std::optional<Vec3d> on_crease(Vec3d p) const {
    constexpr int steps = 4;
    constexpr double parallel = 0.99;
    const double sign = merge_->operation == SolidOperation::difference ? -1 : 1;
    const double near = crease_width * voxel_;
    if (!sharp_ || blunt_.isValueOn(voxel_at(p))) return {};
    const Vec3d start = p;
    for (int step = 0; step < steps; ++step) {
      const auto a = base_.near(p, 2 * near);
      if (!a || std::abs(a->value) > near) return {};
      const auto b = solid_.near(p, 2 * near);
      if (!b || std::abs(b->value) > near) return {};
      const double c = a->normal.dot(b->normal), whole = 1 - c * c;
      if (sign * c < acute_walls || std::abs(c) > parallel) return {};
      p -= ((a->value - c * b->value) * a->normal + (b->value - c * a->value) * b->normal) / whole;
    }
    if ((p - start).norm() > near) return {};
    return p;
  }

  Vec3d on_result(const Vec3d& p) const {
    if (is_base(p)) return base_.closest(p, 2 * voxel_).value_or(p);
    return surface_of_.bring(p);
  }

  /// The result cut along that distance from the solid; nothing where both sides differ, or where its
  /// triangles go through each other.
  std::optional<SurfacePatch> attempt(const PatchMesh& contour) {
    const auto bring = [this](const Vec3d& p) { return base_.closest(p, 2 * voxel_).value_or(p); };
    DividedPatch inner = divide(
        contour, [this](const Vec3d& p) { return cut_ - beyond(p); }, bring);
    std::vector<Index> removed = replaced_triangles(replacement());
    PatchMesh piece = piece_of(*surface_, removed, [this](const Vec3d& p) {
      return beyond(p) > std::max(combined_.contact, merge_->blend) + 2 * voxel_;
    });
    refine(piece, [this](const Vec3d& p) { return size(p); });
    DividedPatch outer = divide(
        std::move(piece), [this](const Vec3d& p) { return beyond(p) - cut_; }, bring);
    agree(outer, inner, join_within * voxel_, shallow * voxel_);
    PatchMesh solid_part = kept_part(inner);
    remove_specks(solid_part, voxel_ * voxel_ * voxel_);
    std::optional<PatchMesh> joined = join(kept_part(outer), solid_part, join_within * voxel_);
    seconds_.join += watch_.lap();
    if (!joined) return {};
    report(merge_->progress, "remeshing the seam", 0);
    improve(*joined, {.size = [this](const Vec3d& p) { return size(p); },
                      .bring = [this](const Vec3d& p) { return on_result(p); },
                      .crease = [this](const Vec3d& p) { return is_on_crease(p); },
                      .smooth = [this](const Vec3d& p) { return is_seam(p); }});
    const std::vector<Index> crossing = crossing_triangles(*joined);
    seconds_.remesh += watch_.lap();
    bad_ = slivers(*joined);
    for (const Index t : crossing) bad_.push_back(middle_of(*joined, t));
    if (!crossing.empty()) {
      crossing_ = bad_.back();
      return {};
    }
    return as_patch(*joined, std::move(removed));
  }

  /// The middles of triangles with small angles that are not parts of the surface.
  std::vector<Vec3d> slivers(const PatchMesh& patch) const {
    std::vector<Vec3d> middles;
    for (Index t = 0; t < patch.triangles.size(); ++t) {
      const auto& [a, b, c] = patch.triangles[t];
      if (worst_cosine(patch.positions[a], patch.positions[b], patch.positions[c]) < sliver_cosine) continue;
      if (const Vec3d middle = middle_of(patch, t); !is_base(middle)) middles.push_back(middle);
    }
    return middles;
  }

  /// Where `beyond` is told.
  Eigen::AlignedBox3d box() const {
    const openvdb::CoordBBox voxels = combined_.solid->evalActiveVoxelBoundingBox();
    const openvdb::Coord low = voxels.min(), high = voxels.max();
    return {voxel_ * Vec3d(low.x(), low.y(), low.z()), voxel_ * Vec3d(high.x(), high.y(), high.z())};
  }

  /// Triangles that may be replaced: of an intersection also all that are far outside.
  std::vector<Index> find_candidates() const {
    constexpr double all = std::numeric_limits<double>::infinity();
    const Vec3d far = Vec3d::Constant(all);
    return triangles_within(*surface_, side_ > 0 ? box() : Eigen::AlignedBox3d(-far, far));
  }

  Replacement replacement() const {
    return {.surface = *surface_,
            .candidates = candidates_,
            .beyond = [this](const Vec3d& p) { return beyond(p); },
            .known = known(),
            .box = box(),
            .near = cut_ + replaced_beyond * voxel_,
            .voxel = voxel_,
            .size = [this](const Vec3d& p) { return size(p); }};
  }

  double size(const Vec3d& p) const {
    const double at = beyond(p), far = at < known() ? at : side_ * solid_(p);
    return edge_length * voxel_ + growth * std::max(std::abs(far - cut_) - replaced_beyond * voxel_, 0.);
  }

  /// Whether triangles there shall be made even. Farther away they are parts of the surface's own.
  bool is_seam(const Vec3d& p) const { return is_base(p) && beyond(p) < cut_ + seam_width * voxel_; }

  SurfacePatch as_patch(const PatchMesh& mesh, std::vector<Index> removed) const {
    SurfacePatch patch;
    patch.removed = std::move(removed);
    std::vector<Index> number;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (mesh.kept[v] != no_index) {
        number.push_back(mesh.kept[v]);
        continue;
      }
      number.push_back(surface_->vertex_count() + static_cast<Index>(patch.positions.size()));
      patch.positions.push_back(mesh.positions[v].cast<float>());
    }
    for (const auto& [a, b, c] : mesh.triangles) patch.triangles.push_back({number[a], number[b], number[c]});
    return patch;
  }

  Stopwatch watch_;
  const SolidMerge* merge_;
  const Surface* surface_;
  double voxel_;
  SurfaceDistance base_;
  SolidSurface solid_surface_;
  SurfaceDistance solid_;
  Combined combined_;
  GridSurface surface_of_;  ///< of the result
  double side_;
  std::vector<Index> candidates_;  ///< triangles that may be replaced, ascending
  double cut_ = 0;      ///< distance from the solid along which surface and contour are cut, object units
  bool sharp_ = false;  ///< whether there is a sharp line where surface and solid meet
  openvdb::BoolTree blunt_;        ///< voxels in which it is not
  TriangleMesh relaxed_;           ///< the contour
  std::vector<Vec3d> bad_;         ///< middles of bad triangles of the result
  std::optional<Vec3d> crossing_;  ///< where the result went through itself
  MergeSeconds seconds_;
};

}  // namespace

MergedSolid merge_solid(const SolidMerge& merge) {
  if (const auto* closed = std::get_if<MeshSolid>(&merge.solid)) {
    const StrokeSolid solid = solid_of(closed->mesh, closed->voxel);
    return merge_solid({merge.surface, merge.picker, solid, merge.operation, merge.blend, merge.progress});
  }
  const StrokeSolid& solid = std::get<0>(merge.solid);
  return solid.empty() ? MergedSolid{} : Merger(merge, solid).run();
}

}  // namespace burin
