// Puts the patch of a merged solid into a painted surface, with paint interpolated at the closest points of
// the old surface, and measures the result for the report.
#include <burin/base/parallel.h>
#include <burin/host/session/merged_surface.h>
#include <burin/math/elementary.h>
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/euler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin {
namespace {

/// The mean colour of the corners around a point, by their weights.
Vec4f colour_at(const Paint& paint, const SurfacePoint& place) {
  Tint sum = Tint::Zero();
  for (std::size_t i = 0; i < 3; ++i) sum += place.weights[i] * tint_of(paint.colour_of(place.corners[i]), 1);
  return colour_of(sum);
}

float mask_at(const Paint& paint, const SurfacePoint& place) {
  float sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += place.weights[i] * paint.mask_of(place.corners[i]);
  return std::clamp(sum, 0.0F, 1.0F);
}

/// Degrees.
double least_angle(const Surface& surface, const SurfacePatch& patch) {
  const auto place = [&](Index v) {
    const Index old = surface.vertex_count();
    return (v < old ? surface.positions[v] : patch.positions[v - old]).cast<double>().eval();
  };
  double greatest = -1;  // cosine
  for (const Triangle& t : patch.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d at = place(t[i]), a = place(t[(i + 1) % 3]) - at, b = place(t[(i + 2) % 3]) - at;
      greatest = std::max(greatest, a.stableNormalized().dot(b.stableNormalized()));
    }
  return math::atan2(std::sqrt(std::max(1 - greatest * greatest, 0.)), greatest) * 180 / std::numbers::pi;
}

}  // namespace

PaintedPatch with_patch(const Surface& surface, const Picker& picker, const Paint& paint,
                        const SurfacePatch& patch) {
  PatchedSurface made = patched(surface, patch);
  PaintedPatch result{{std::move(made.surface), {}}, std::move(made.came_from)};
  PaintedSurface& painted = result.painted;
  const std::size_t count = result.came_from.size();
  if (paint.colour.empty() && paint.mask.empty()) return result;
  if (!paint.colour.empty()) painted.paint.colour.resize(count);
  if (!paint.mask.empty()) painted.paint.mask.resize(count);
  parallel_blocks(count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Index from = result.came_from[v];
      const bool is_new = from >= surface.vertex_count();
      SurfacePoint place{no_index, {from, from, from}, {1, 0, 0}, {}};
      if (is_new) place = *picker.closest(painted.surface.positions[v], std::numeric_limits<float>::max());
      if (!paint.colour.empty())
        painted.paint.colour[v] = is_new ? colour_at(paint, place) : paint.colour[from];
      if (!paint.mask.empty()) painted.paint.mask[v] = is_new ? mask_at(paint, place) : paint.mask[from];
    }
  });
  return result;
}

MergeReport report_of(const MergedSolid& merged, const Surface& before, const Surface& after) {
  return {.voxel = merged.voxel,
          .voxels = merged.voxels,
          .bytes = merged.bytes,
          .triangles_removed = merged.patch.removed.size(),
          .triangles_added = merged.patch.triangles.size(),
          .euler_before = euler_characteristic(before),
          .euler_after = euler_characteristic(after),
          .least_angle = least_angle(before, merged.patch),
          .seconds = merged.seconds};
}

}  // namespace burin
