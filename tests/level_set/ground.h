#pragma once
#include <burin/level_set/solid_mesh.h>
#include <burin/surface/surface_patch.h>

#include <optional>
#include <utility>
#include <vector>

#include "support/charted.h"
#include "support/closed_curve.h"

namespace burin::test {

/// A surface with the solid that a stroke made on it.
struct Ground {
  static constexpr double radius = 0.2;  ///< of the stroke

  Charted charted;
  Chart chart;
  std::optional<StrokeSolid> solid;

  Ground(TriangleMesh mesh, const std::vector<Vec3d>& samples, bool closed) : charted(std::move(mesh)) {
    charted.builder.begin({.radius = radius});
    charted.curve = traced(CurveGround(charted.surface, charted.picker, charted.builder.base()),
                           charted.picker, radius, samples);
    if (closed) close(charted.curve);
    chart = charted.builder.draw(charted.curve).sorted();
  }

  void lay(const DistanceToSolid& distance, double lowest, double highest, double voxel) {
    const SolidGround base{charted.surface, chart, [&](Index v) { return charted.surface.positions[v]; }};
    const SolidExtent extent{.h_min = lowest, .h_max = highest, .radius = radius, .voxel = voxel};
    solid.emplace(base, extent, distance);
  }

  TriangleMesh before() const { return {charted.surface.positions, charted.surface.triangles, {}}; }

  SurfacePatch merged(SolidOperation operation, double blend) const {
    return merge_solid({charted.surface, charted.picker, *solid, operation, blend}).patch;
  }

  TriangleMesh after(const SurfacePatch& patch) const {
    const PatchedSurface result = patched(charted.surface, patch);
    return {result.surface.positions, result.surface.triangles, {}};
  }

  /// The new triangles alone.
  TriangleMesh fresh(const SurfacePatch& patch) const {
    TriangleMesh mesh{charted.surface.positions, patch.triangles, {}};
    mesh.positions.insert(mesh.positions.end(), patch.positions.begin(), patch.positions.end());
    return mesh;
  }
};

}  // namespace burin::test
