#pragma once
#include <burin/host/session.h>
#include <burin/host/session/stroke_lines.h>
#include <burin/refine/near_vertices.h>
#include <burin/refine/refine_surface.h>
#include <burin/stroke/stroke_settings.h>

#include <optional>
#include <span>

namespace burin {

/// Whether strokes with these settings may refine a surface that is too coarse for them as it was given: two
/// of its vertices are farther from each other than half of the radius.
bool may_refine_if_coarse(const GivenShape& given, const StrokeSettings& settings);

/// What a stroke needs of its surface.
struct PathRefinement {
  bool is_coarse = false;                      ///< the surface as it was given is too coarse for the stroke
  std::optional<SurfaceRefinement> made = {};  ///< none where there is nothing to do
  double edge = 0;                             ///< the least length that edges get, object units
  double seconds = 0;                          ///< that it took to find
  double declined = 0;  ///< about how many triangles it would add, more than an automatic refinement may
};

/// The most triangles that automatic refinements of a session add. What needs more was hardly meant.
inline constexpr double most_automatic = 1e6;

/// What refines a surface for a stroke through these places near it, and its images, as
/// StrokeSettings::refining says. Throws Error where `edge` would take more than 10 million triangles, if
/// possible before it starts. Refines it for later strokes that need edges of the same length too, as long as
/// bounds allow; these are asked for if there is anything to do for this one. `added`: triangles that were
/// added before and count for the bound. `near`: to work with.
PathRefinement refined_along(const StrokeGround& ground, const StrokeSettings& settings,
                             std::span<const Vec3d> path, const LaterStrokes& later, std::size_t added,
                             NearVertices& near);

/// Where a pen comes to.
struct PenStep {
  Vec3d from, to;    ///< on the surface, object units
  double drawn = 0;  ///< length of the stroke so far

  double length() const { return (to - from).norm(); }
};

/// The same for one step of the pen. If there is anything to do, what lies ahead is refined too: half as much
/// as was drawn, and at least some radii, so that a stroke is interrupted the less often the longer it is.
/// Costs O(vertices within the radius) if there is not, and nothing where an automatic refinement finds
/// nothing to do anywhere.
PathRefinement refined_at(const StrokeGround& ground, const StrokeSettings& settings, const PenStep& step,
                          std::size_t added, NearVertices& near);

/// What represents the displacement of a stroke to the error of its settings, or more nearly; see
/// displacement_error(). Throws Error where that would add more than 10 million triangles.
PathRefinement refined_to_error(const Surface& surface, const StrokeSettings& settings,
                                std::span<const Vec3f> displaced, std::span<const Index> vertices);

}  // namespace burin
