#pragma once
#include <burin/deform/paint.h>
#include <burin/host/session.h>
#include <burin/surface/picker.h>
#include <burin/volume/solid.h>

#include <vector>

namespace burin {

/// A surface and its paint.
struct PaintedSurface {
  Surface surface;
  Paint paint;
};

/// The same after a patch.
struct PaintedPatch {
  PaintedSurface painted;
  std::vector<Index> came_from;  ///< see PatchedSurface
};

/// Puts a patch into a painted surface. New vertices take the paint of the closest place of the surface, to
/// which the picker belongs.
PaintedPatch with_patch(const Surface& surface, const Picker& picker, const Paint& paint,
                        const SurfacePatch& patch);

/// What a merge did to a surface, of which `after` came.
MergeReport report_of(const MergedSolid& merged, const Surface& before, const Surface& after);

}  // namespace burin
