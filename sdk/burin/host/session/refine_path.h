#pragma once
#include <burin/refine/coarse_edges.h>
#include <burin/refine/refine_surface.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/surface/picker.h>

#include <optional>
#include <span>

namespace burin {

/// About the length of the edges into which a stroke refines a surface, object units.
double refined_edge(const StrokeSettings& settings);

/// The patch that refines a surface for a stroke through these places near it, and its images, as
/// StrokeSettings::refining says; nothing where there is nothing to do. Throws Error where that would take
/// more than 10 million triangles, if possible before it starts.
std::optional<SurfacePatch> refined_along(const Surface& surface, const Picker& picker,
                                          const StrokeSettings& settings, std::span<const Vec3d> path);

/// Where a pen comes to.
struct PenStep {
  Vec3d from, to;    ///< on the surface, object units
  double drawn = 0;  ///< length of the stroke so far

  double length() const { return (to - from).norm(); }
};

/// The same for one step of the pen. If there is anything to do, what lies ahead is refined too: half as much
/// as was drawn, and at least some radii, so that a stroke is interrupted the less often the longer it is.
/// Costs O(vertices within the radius) if there is not.
std::optional<SurfacePatch> refined_at(const Surface& surface, const Picker& picker,
                                       const StrokeSettings& settings, const PenStep& step,
                                       CoarseEdges& coarse);

}  // namespace burin
