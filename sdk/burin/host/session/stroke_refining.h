#pragma once
#include <burin/host/session/coarsen_path.h>
#include <burin/host/session/given_samples.h>
#include <burin/host/session/refine_path.h>
#include <burin/host/session/sculpted_surface.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// How the surface is refined for the open stroke of a session: what the stroke was given so far, to draw it
/// again, and what was refined for it.
class StrokeRefining {
 public:
  /// For a stroke that may refine. `added`: triangles that earlier strokes added, which count for the bound
  /// of automatic refinements, as what each stroke costs grows with them. `later`: the strokes that follow.
  void begin(const BrushEntry* entry, const StrokeSettings& settings, std::size_t added, LaterStrokes later);

  /// For a stroke that does not, or not any more. What was refined for it stays.
  void end() { given_.reset(); }
  bool is_on() const { return given_.has_value(); }

  /// Of a stroke that may refine.
  GivenSamples& given() { return *given_; }

  /// What is to be refined for a path and later strokes, for a place that the pen comes to, and for what the
  /// finished stroke displaced, if its settings name an error. See refine_path.h; throw as these do.
  PathRefinement along(SculptedSurface& surface, std::span<const Vec3d> path);
  PathRefinement at(const SculptedSurface& surface, const Vec3d& place);
  PathRefinement to_error(SculptedSurface& surface);

  /// What the finished stroke does not need of what others refined; see coarsen_path.h.
  PathCoarsening coarser(SculptedSurface& surface);

  /// Why the stroke is drawn on the triangles that are there, if it would take too many; empty if not. Such a
  /// stroke does not refine any more.
  std::string declined(const PathRefinement& refinement);

  /// Whether the stroke must be opened anew for a refinement.
  bool changes(const PathRefinement& refinement) const;

  /// Puts it into the surface, to which no stroke may refer.
  void apply(const PathRefinement& refinement, SculptedSurface& surface);

  /// Keeps the finished stroke without what it does not need, if that is anything. No stroke may refer to the
  /// surface.
  void keep(MadePart made, PathCoarsening coarser, SculptedSurface& surface);

  /// What was refined for the stroke, if anything; nothing is known of it afterwards.
  std::optional<RefineReport> take_report();

 private:
  std::size_t added() const;

  std::optional<GivenSamples> given_;
  LaterStrokes later_;
  std::optional<RefineReport> report_;
  std::size_t added_before_ = 0;
  NearVertices near_;
};

}  // namespace burin
