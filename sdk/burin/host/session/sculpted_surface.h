#pragma once
#include <burin/deform/shown/shown_paint.h>
#include <burin/deform/shown/shown_surface.h>
#include <burin/deform/shown/undo_journal.h>
#include <burin/host/session.h>
#include <burin/host/session/coarsen_path.h>
#include <burin/host/session/merged_surface.h>
#include <burin/host/session/stroke_instance.h>
#include <burin/host/session/surface_state.h>
#include <burin/host/session/vertex_moves.h>
#include <burin/refine/given_shape.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Which way a finished stroke is taken: undone, or made again.
enum class Turn { undo, redo };

/// The surface of a session with all that depends on it, as it is shown while a stroke is open, and the steps
/// that undo finished strokes. Neither copied nor moved, since pickers and builders refer to its surface.
class SculptedSurface {
 public:
  explicit SculptedSurface(Surface surface);
  SculptedSurface(const SculptedSurface&) = delete;
  SculptedSurface& operator=(const SculptedSurface&) = delete;

  const Surface& base() const { return surface_; }  ///< before the open stroke
  const Picker& picker() const { return picker_; }  ///< of base()
  ChartBuilders& builders() { return *builders_; }  ///< for strokes on base()
  const GivenShape& given() const { return given_; }
  void keep_given_positions() { given_.keep_positions(surface_); }
  const ShownSurface& shown() const { return shown_; }
  const ShownPaint& paint() const { return paint_; }
  std::uint64_t generation() const { return generation_; }  ///< how often the surface was replaced

  /// The vertices that the last call changed.
  std::span<const Index> changed() const { return changed_; }
  void clear_changed() {
    changed_.clear();
    kept_vertices_ = surface_.vertex_count();
  }

  /// How many vertices, by their numbers in the source, were there before clear_changed() and all the time
  /// since.
  Index kept_vertices() const { return kept_vertices_; }
  std::span<const Index> note_all_changed();

  /// Sets the paint. Throws ContractError unless there are none or one value per vertex, from 0 to 1.
  void set_paint(Paint paint);
  void prepare_paint(std::uint64_t outputs) { paint_.prepare(outputs); }

  /// Moves vertices of base(), which has no step of undo. Throws ContractError for what is no such vertex or
  /// not finite.
  void move(std::span<const Index> vertices, std::span<const Vec3f> positions);

  /// Shows what an open stroke moved and painted.
  void show(const VertexMoves& moves);

  /// Shows the surface without the open stroke again.
  void drop();

  /// Hides triangles, by their numbers before any was hidden; empty: none. Throws as Session::hide() does,
  /// then nothing changes. No stroke may refer to the surface.
  void hide(const std::vector<bool>& hidden);
  void require_all_shown() const;  ///< throws Error if triangles are hidden
  bool hides() const { return all_triangles_.has_value(); }

  /// The vertices that the open stroke moved, ascending.
  std::vector<Index> displaced() { return shown_.displaced(surface_); }

  /// Makes the shown surface and paint those of base(), with an undo step. `kept`: what refinement keeps from
  /// now on, of vertices of base(); the step takes that back too.
  void keep(MadePart made, KeptEdges kept);

  /// The same without vertices that the open stroke does not need. No stroke may refer to the surface any
  /// more.
  void keep_coarser(MadePart made, PathCoarsening coarser);

  /// Replaces a part of the surface, with an undo step. No stroke may refer to the surface any more.
  void replace(PaintedPatch made);

  /// Refines the surface for a stroke that is to be drawn on it: both become one step of undo, and drop()
  /// takes both back. No stroke may refer to the surface. Chart builders are new ones. `added`: new vertices,
  /// as in SurfaceRefinement.
  void refine(PaintedPatch made, const AddedVertices& added);
  bool is_refined() const { return unrefined_.has_value(); }  ///< for a stroke that is not finished

  /// Undoing and redoing take two calls: show() moves the vertices of the step, and restore() makes that the
  /// surface. For a step that holds a surface restore() does both. What restore() replaces is a step for the
  /// other way. A stroke that is kept ends redoing.
  std::optional<UndoStep> take_step(Turn turn) { return steps(turn).take(); }
  std::size_t step_count(Turn turn) const { return turn == Turn::undo ? journal_.size() : undone_.size(); }
  void show(const UndoStep& step);
  void restore(UndoStep step, Turn turn);

  /// Takes the newest step out, for an application's own undo; nothing if there is none. Throws Error for one
  /// that holds more than values of vertices.
  std::optional<StrokeStep> release_step();

  /// Gives the vertices of a step its values; the step then has those that they had. Throws Error, and
  /// changes nothing, unless the surface is in the state that the step belongs to.
  void apply(StrokeStep& step);

  /// Bounds the bytes of the steps of both ways.
  void limit_undo(std::size_t bytes);
  std::size_t undo_bytes() const { return journal_.bytes() + undone_.bytes(); }
  std::size_t undo_dropped() const { return undo_dropped_; }  ///< steps, so far

 private:
  /// What belongs to a surface and cannot be made of it later: chart builders made anew would have other
  /// clusters.
  struct Kept {
    std::unique_ptr<ChartBuilders> builders;
    GivenShape given;
    Index same = 0;  ///< vertices, by their numbers in the source, that are in what replaced it too
  };

  /// A surface that was replaced.
  struct Replaced {
    PaintedSurface painted;
    Kept kept;
  };

  /// Triangles of a surface, with texture coordinates if it has them.
  struct Triangles {
    std::vector<Triangle> corners;
    std::vector<TriangleUv> uv;
  };

  UndoJournal& steps(Turn turn) { return turn == Turn::undo ? journal_ : undone_; }
  std::vector<Kept>& kept_of(Turn turn) { return turn == Turn::undo ? replaced_ : undone_replaced_; }
  void end_redoing();
  Triangles shown_triangles(const std::vector<bool>& hidden) const;
  void drop_oldest();
  UndoStep restore_surface(UndoStep step, Turn turn);
  UndoStep restore_vertices(UndoStep step);
  std::uint64_t state() { return state_.of(surface_, paint_.base()); }
  void note_changed(std::span<const Index> moved, std::span<const Index> painted);
  void commit(std::span<const Index> displaced);
  Index same_numbers(const PaintedPatch& made) const;
  Replaced exchange(PaintedSurface made, Kept kept);
  void record_replaced(Replaced replaced, UndoStep step);

  Surface surface_;
  Picker picker_;
  std::unique_ptr<ChartBuilders> builders_;
  GivenShape given_;
  std::vector<Kept> replaced_, undone_replaced_;  ///< of the steps that hold surfaces
  std::optional<Triangles> all_triangles_;        ///< while some are hidden
  std::optional<Replaced> unrefined_;             ///< while a stroke on a refined surface is not finished
  ShownSurface shown_;
  ShownPaint paint_;
  UndoJournal journal_, undone_;
  std::size_t most_undo_bytes_ = std::numeric_limits<std::size_t>::max(), undo_dropped_ = 0;
  SurfaceState state_;  ///< of base() and the paint before the open stroke
  std::vector<Index>
      of_source_;  ///< [vertex of the original mesh] its number; made for the first step applied
  std::vector<Index> changed_;
  Index kept_vertices_ = 0;
  std::uint64_t generation_ = 0;
};

}  // namespace burin
