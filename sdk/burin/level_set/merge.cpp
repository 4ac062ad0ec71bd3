// Sets of triangles that are joined through voxels. The result's distance is contoured around the solid. The
// surface is cut, and the contour too, along the line on which the solid is as far as the result differs from
// the surface and a voxel more; there both lie on the surface, and are joined. The seam is remeshed.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/level_set/combine.h>
#include <burin/level_set/grid/grid_surface.h>
#include <burin/level_set/grid/rolling_ball.h>
#include <burin/level_set/relaxed_mesh.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/level_set/surface_distance.h>
#include <burin/remesh/clip.h>
#include <burin/remesh/improve.h>
#include <burin/remesh/join.h>
#include <burin/remesh/refine.h>
#include <burin/remesh/specks.h>
#include <fmt/format.h>
#include <openvdb/tools/Interpolation.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// The voxel's share by which the cut lies beyond what differs, and by which triangles are replaced beyond
/// it.
constexpr double cut_beyond = 1.2, replaced_beyond = 0.7;

/// Edges of new triangles, voxels, and how they grow away from the cut.
constexpr double edge_length = 1.2, growth = 0.7;

/// How far beyond the cut triangles are made even, voxels.
constexpr double seam_width = 2.5;

/// How far vertices may be from a crease to find it, to be brought to it, and to count as on it; voxels.
constexpr double crease_width = 1, snap = 0.3, on_crease_within = 1e-3;

/// The surface of a solid, for distances to it.
struct SolidSurface {
  explicit SolidSurface(const StrokeSolid& solid) : surface(make_surface(mesh_of(solid))), picker(surface) {}

  Surface surface;
  Picker picker;
};

class Merger {
 public:
  explicit Merger(const SolidMerge& merge)
      : merge_(&merge),
        surface_(&merge.surface),
        voxel_(merge.solid.voxel()),
        base_(merge.surface, merge.picker),
        solid_surface_(merge.solid),
        solid_(solid_surface_.surface, solid_surface_.picker),
        combined_(combine({merge.solid, solid_, base_, merge.operation, merge.blend})),
        surface_of_(*combined_.result),
        side_(merge.operation == SolidOperation::intersection ? -1 : 1) {}

  MergedSolid run() {
    const PatchMesh contour = contoured();
    // Where the line that they are cut along nearly touches itself, the two may differ; elsewhere they do
    // not.
    constexpr int tries = 6;
    constexpr double step = 0.2;  // voxels
    for (int i = 0; i < tries; ++i) {
      cut_ = combined_.contact + (cut_beyond + i * step) * voxel_;
      if (std::optional<SurfacePatch> patch = attempt(contour))
        return {std::move(*patch), combined_.result->tree().leafCount() * VoxelBlock::voxels,
                combined_.bytes};
    }
    throw Error("the solid's surface and the rest cannot be joined here: try another voxel");
  }

 private:
  /// How far a point is from the solid, on the side on which the surface stays; object units.
  double beyond(const Vec3d& p) const {
    const Vec3d at = p / voxel_;
    const Grid& grid = *combined_.solid;
    return side_ * static_cast<double>(openvdb::tools::BoxSampler::sample(
                       grid.tree(), openvdb::Vec3d(at.x(), at.y(), at.z())));
  }
  double known() const { return static_cast<double>(combined_.solid->background()); }

  /// The surface of the result around the solid, brought to the surface itself where it is that.
  PatchMesh contoured() const {
    TriangleMesh mesh = surface_of_.mesh();
    relax(mesh, [&](std::vector<Vec3f>& positions) { surface_of_.bring(positions); });
    PatchMesh patch;
    patch.triangles = std::move(mesh.triangles);
    patch.kept.assign(mesh.positions.size(), no_index);
    patch.positions.resize(mesh.positions.size());
    parallel_blocks(patch.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        // Where the voxels end is a wall within the surface, which is cut off.
        const Vec3d p = mesh.positions[v].cast<double>();
        patch.positions[v] = is_base(p) ? base_.closest(p, voxel_ / 2).value_or(p) : snapped(p);
      }
    });
    if (!(merge_->blend > 0)) sharpen(patch);
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

  /// The point of the line in which surface and solid meet, for one near it, where no fillet fills the line.
  std::optional<Vec3d> on_crease(Vec3d p) const {
    constexpr int steps = 4;
    constexpr double parallel = 0.99;
    const double sign = merge_->operation == SolidOperation::difference ? -1 : 1;
    const double near = crease_width * voxel_;
    if (merge_->blend > 0) return {};
    const Vec3d start = p;
    for (int step = 0; step < steps; ++step) {
      const auto a = base_.near(p, 2 * near), b = solid_.near(p, 2 * near);
      if (!a || !b || std::abs(a->value) > near || std::abs(b->value) > near) return {};
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

  std::optional<SurfacePatch> attempt(const PatchMesh& contour) {
    const auto bring = [this](const Vec3d& p) { return base_.closest(p, 2 * voxel_).value_or(p); };
    PatchMesh inner = contour;
    clip(
        inner, [this](const Vec3d& p) { return cut_ - beyond(p); }, bring);
    remove_specks(inner, voxel_ * voxel_ * voxel_);
    std::vector<Index> removed = replaced();
    grow(removed);
    PatchMesh outer = piece(removed);
    refine(outer, [this](const Vec3d& p) { return size(p); });
    clip(
        outer, [this](const Vec3d& p) { return beyond(p) - cut_; }, bring);
    std::optional<PatchMesh> joined = join(outer, inner, 0.5 * voxel_);
    if (!joined) return {};
    improve(*joined, {.size = [this](const Vec3d& p) { return size(p); },
                      .bring = [this](const Vec3d& p) { return on_result(p); },
                      .crease = [this](const Vec3d& p) { return is_on_crease(p); },
                      .smooth = [this](const Vec3d& p) { return is_seam(p); }});
    return as_patch(*joined, std::move(removed));
  }

  double size(const Vec3d& p) const {
    const double at = beyond(p), far = at < known() ? at : side_ * solid_(p);
    return edge_length * voxel_ + growth * std::max(std::abs(far - cut_) - replaced_beyond * voxel_, 0.);
  }

  /// Whether triangles there shall be made even. Farther away they are parts of the surface's own.
  bool is_seam(const Vec3d& p) const { return is_base(p) && beyond(p) < cut_ + seam_width * voxel_; }

  /// Whether a part of the triangle may be as near as triangles are replaced.
  bool is_near(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    const Vec3d middle = (a + b + c) / 3;
    const double radius = std::sqrt(
        std::max({(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));
    const double at = beyond(middle), near = cut_ + replaced_beyond * voxel_;
    if (at < near) return true;
    if (at < known() ? at - radius >= near : known() - radius >= near) return false;
    if (!box_.intersects(
            Eigen::AlignedBox3d(middle - Vec3d::Constant(radius), middle + Vec3d::Constant(radius))))
      return false;
    if (radius < voxel_) return at - radius < near;
    const Vec3d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    return is_near(a, ab, ca) || is_near(ab, b, bc) || is_near(ca, bc, c) || is_near(ab, bc, ca);
  }

  /// The triangles of the surface that a part of is near the solid, ascending.
  std::vector<Index> replaced() {
    const openvdb::CoordBBox voxels = combined_.solid->evalActiveVoxelBoundingBox();
    const openvdb::Coord low = voxels.min(), high = voxels.max();
    box_ = {voxel_ * Vec3d(low.x(), low.y(), low.z()), voxel_ * Vec3d(high.x(), high.y(), high.z())};
    std::vector<char> near(surface_->triangles.size(), 0);
    parallel_blocks(near.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const Triangle& triangle = surface_->triangles[t];
        const Vec3d a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
        near[t] = is_near(a, b, c);
      }
    });
    std::vector<Index> list;
    for (Index t = 0; t < near.size(); ++t)
      if (near[t]) list.push_back(t);
    return list;
  }

  Vec3d corner(const Triangle& triangle, std::size_t i) const {
    return surface_->positions[triangle[i]].cast<double>();
  }

  /// Adds triangles beyond sides that are too long for what is to come beside them, so that these can be
  /// split.
  void grow(std::vector<Index>& removed) const {
    constexpr double too_long = 2;
    std::vector<bool> chosen(surface_->triangles.size(), false);
    for (const Index t : removed) chosen[t] = true;
    for (std::size_t i = 0; i < removed.size(); ++i) {
      const Triangle triangle = surface_->triangles[removed[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d from = corner(triangle, k), to = corner(triangle, (k + 1) % 3);
        if ((to - from).norm() <= too_long * least_size([this](const Vec3d& p) { return size(p); }, from, to))
          continue;
        const Index other = across(triangle[(k + 1) % 3], triangle[k]);
        if (other == no_index || chosen[other]) continue;
        chosen[other] = true;
        removed.push_back(other);
      }
    }
    std::ranges::sort(removed);
  }

  /// The triangle whose side leads from one vertex to the other.
  Index across(Index from, Index to) const {
    for (const Index number : surface_->incident[from]) {
      const Triangle& t = surface_->triangles[number];
      for (std::size_t i = 0; i < 3; ++i)
        if (t[i] == from && t[(i + 1) % 3] == to) return number;
    }
    return no_index;
  }

  /// These triangles by themselves. Vertices that others have too, or that are far from the solid, are kept.
  PatchMesh piece(const std::vector<Index>& triangles) const {
    std::vector<Index> number(surface_->vertex_count(), no_index);
    PatchMesh piece;
    const auto is_removed = [&](Index t) { return std::ranges::binary_search(triangles, t); };
    for (const Index t : triangles) {
      Triangle own{};
      for (std::size_t i = 0; i < 3; ++i) {
        const Index vertex = surface_->triangles[t][i];
        if (number[vertex] == no_index) {
          number[vertex] = piece.vertex_count();
          piece.positions.push_back(surface_->positions[vertex].cast<double>());
          const bool inside = std::ranges::all_of(surface_->incident[vertex], is_removed);
          const bool far =
              beyond(piece.positions.back()) > std::max(combined_.contact, merge_->blend) + 2 * voxel_;
          piece.kept.push_back(!inside || far ? vertex : no_index);
        }
        own[i] = number[vertex];
      }
      check_sides(surface_->triangles[t]);
      piece.triangles.push_back(own);
    }
    return piece;
  }

  /// Each side must be that of one other triangle, in the other direction.
  void check_sides(const Triangle& triangle) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = triangle[i], to = triangle[(i + 1) % 3];
      std::size_t same = 0, other = 0;
      for (const Index number : surface_->incident[from]) {
        const Triangle& t = surface_->triangles[number];
        for (std::size_t k = 0; k < 3; ++k) {
          if (t[k] == from && t[(k + 1) % 3] == to) ++same;
          if (t[k] == to && t[(k + 1) % 3] == from) ++other;
        }
      }
      if (same == 1 && other == 1) continue;
      const Vec3f& at = surface_->positions[from];
      throw Error(fmt::format("the surface is {} at ({:.6g}, {:.6g}, {:.6g}), where the solid meets it",
                              same == 1 && other == 0 ? "open" : "no manifold", at.x(), at.y(), at.z()));
    }
  }

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

  const SolidMerge* merge_;
  const Surface* surface_;
  double voxel_;
  SurfaceDistance base_;
  SolidSurface solid_surface_;
  SurfaceDistance solid_;
  Combined combined_;
  GridSurface surface_of_;  ///< of the result
  double side_;
  double cut_ = 0;  ///< distance from the solid along which surface and contour are cut, object units
  Eigen::AlignedBox3d box_;  ///< of the voxels
};

}  // namespace

MergedSolid merge_solid(const SolidMerge& merge) {
  if (merge.solid.empty()) return {};
  return Merger(merge).run();
}

}  // namespace burin
