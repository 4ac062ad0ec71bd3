#pragma once
#include <burin/base/error.h>
#include <burin/chart/chart.h>
#include <burin/deform/paint.h>
#include <burin/host/brush_library.h>
#include <burin/host/event_cost.h>
#include <burin/stroke/curve.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// When a sample updates the shown surface. Deferring saves time; the result of the stroke is the same.
enum class Show {
  now,
  later,  ///< with the next sample that is shown, or at the end of the stroke; for samples that arrive in
          ///< groups
};

/// The result of one sample.
struct StrokeEvent {
  enum class Outcome {
    drawn,         ///< the stroke was extended to the sample; with Show::later it is shown later
    off_surface,   ///< the ray misses the surface, or the position is not near it; nothing changed
    disconnected,  ///< the sample is on the surface, but across a gap or silhouette; nothing changed
  };
  Outcome outcome = Outcome::off_surface;
  /// The vertices that moved, their neighbours, whose normals may have changed, and vertices whose colour or
  /// mask changed; ascending. Valid until the next call.
  std::span<const Index> changed;
};

/// A stroke that is not drawn yet.
struct PlannedStroke {
  StrokeSettings settings;
  std::vector<Vec3d> path;  ///< places of the surface where it will go, in order, object units
};
using LaterStrokes = std::function<std::vector<PlannedStroke>()>;

/// What a stroke did that merged a solid with the surface.
struct MergeReport {
  double voxel = 0;        ///< edge, object units
  std::size_t voxels = 0;  ///< in which both were compared
  std::size_t bytes = 0;   ///< of their grids
  std::size_t triangles_removed = 0, triangles_added = 0;
  long euler_before = 0, euler_after = 0;  ///< vertices - edges + triangles
  double least_angle = 0;                  ///< of the added triangles, degrees
  MergeSeconds seconds;
  double solid_seconds = 0, rebuild_seconds = 0;  ///< making the solid, and all that depends on the surface
};

/// What refining the surface for a stroke did, and taking out what the stroke did not need.
struct RefineReport {
  double edge = 0;  ///< about the length of the new edges, or of those that are left, object units
  std::size_t triangles_removed = 0, triangles_added = 0;
  std::size_t vertices_added = 0, vertices_removed = 0;  ///< removed: what earlier strokes added
  double split_seconds = 0, collapse_seconds = 0;        ///< until it was known what is added, and removed
  double rebuild_seconds = 0;                            ///< all that depends on the surface
};

/// What a finished stroke did, as an object that the undo stack of an application holds: the values that the
/// vertices which it changed have on its other side. See Session::take_step() and Session::apply(). Vertices
/// are those of the mesh that the session was made of (Surface::source_vertex), so that a step belongs to
/// every session of that mesh.
struct StrokeStep {
  std::vector<Index> vertices;          ///< that move, each once
  std::vector<Vec3f> positions;         ///< [i] of vertices[i], object units
  std::vector<Index> painted_vertices;  ///< each once
  std::vector<Vec4f> colours;           ///< [i] of painted_vertices[i], or empty
  std::vector<float> masks;             ///< [i] of painted_vertices[i], or empty
  /// Sums over all values of a surface: of the only surfaces that the step may be applied to, and of what
  /// they become.
  std::uint64_t from = 0, to = 0;

  std::size_t bytes() const;  ///< of memory
};

/// The bytes of a file or of an application's document: little-endian, with a checksum.
std::vector<std::byte> saved_step(const StrokeStep& step);
std::size_t saved_bytes(const StrokeStep& step);  ///< how many these are

/// Reads what saved_step() wrote. Throws Error for bytes that are damaged, cut off or of something else.
StrokeStep loaded_step(std::span<const std::byte> bytes);

/// A surface that is being sculpted: the main class for embedding applications. One stroke at a time is
/// drawn, sample by sample; it displaces the surface as it was when the stroke began. Vertex indices are
/// those of surface(). A session belongs to one thread at a time; inside it uses all threads of oneTBB. If a
/// call throws, the open stroke is dropped: the surface is as before the stroke, and no stroke is open.
class Session {
 public:
  /// Takes the surface; see make_surface(). `brushes` must outlive the session. `merger`: what merges solids
  /// with the surface, such as merge_solid() of the component `solids`; without it strokes that would throw
  /// Error. Throws ContractError for a point set, since the normals of moved points would require triangles.
  Session(Surface surface, const BrushLibrary& brushes, SolidMerger merger = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// The surface after the last finished stroke. Its arrays stay in place until generation() changes.
  const Surface& surface() const;

  /// Changes whenever the surface is replaced by one of other vertices and triangles: where a stroke refines
  /// it, when a stroke ends that merged a solid with it or took out what finer strokes had refined, and when
  /// any of these is undone or dropped. All indices of vertices are new then.
  std::uint64_t generation() const;

  /// How many vertices were there before the last non-const call and are there after it, by their numbers in
  /// Surface::source_vertex: those below. Others have other numbers now, or are new.
  Index kept_vertices() const;
  const Picker& picker() const;  ///< of that surface

  /// The current positions, object units, and unit normals by vertex, including the open stroke.
  std::span<const Vec3f> positions() const;
  std::span<const Vec3f> normals() const;  ///< unit

  /// The current colours and masks by vertex, including the open stroke; an array may be empty.
  const Paint& paint() const;

  /// Replaces all colours and masks; this cannot be undone. Throws ContractError if a stroke is open, if an
  /// array is neither empty nor has one element per vertex, or if a value is outside 0..1.
  void set_paint(Paint paint);

  /// Moves vertices, which must be distinct, as other tools of the application did: the surface from now on.
  /// It is no step of undo. Steps hold positions: an application whose own undo takes such moves back in turn
  /// with strokes gets every state again, others undo a stroke to where its vertices were before it. Costs
  /// what moved; changed() lists it. Throws ContractError if a stroke is open, if there is not one position
  /// for each vertex, or for a vertex or position that is not there or not finite.
  void move_vertices(std::span<const Index> vertices, std::span<const Vec3f> positions);

  /// Hides triangles from now on, or shows them again: as if the surface had only the others, so that pens
  /// and charts end where they begin, and vertices without any other triangle keep their bits. `hidden`: for
  /// each triangle that surface() had when it was made; empty: none. Vertices keep their numbers, and undo
  /// and redo go on; all normals are those of what is shown. Strokes can neither refine such a surface nor
  /// merge solids with it. Costs as much as a new surface. Throws Error if no triangle with an area would be
  /// left, or if a stroke that can be undone or made again replaced triangles; ContractError if a stroke is
  /// open or for another number of triangles.
  void hide(const std::vector<bool>& hidden);

  /// Is called while the end of a stroke makes a solid and merges it with the surface, which can take
  /// seconds, on the thread of that call. If it throws, so does the call, and the surface is as before the
  /// stroke: that is how users cancel.
  void set_progress(Progress progress);

  /// The solids that strokes with SolidOperation::separate made beside the surface, in the order of the
  /// strokes.
  std::span<const StrokeSolid> parts() const;

  /// What the strokes did that merged a solid with the surface, in their order.
  std::span<const MergeReport> merges() const;

  /// What strokes refined, in their order.
  std::span<const RefineReport> refinements() const;

  /// What authors should know of what their brushes did in the strokes so far: lines "ID: ...".
  std::span<const std::string> warnings() const;

  /// The meshes that strokes with StrokeSettings::along laid beside the surface, one of each stroke that did
  /// not merge them with it, in the order of the strokes. Object units; with the texture coordinates that
  /// their sources have.
  std::span<const TriangleMesh> bent_meshes() const;

  /// Opens a stroke. Throws Error for an unknown brush or parameter, a value out of range, a file that cannot
  /// be read, a mesh that cannot be bent, a brush with inputs that this host does not provide, or dynamics of
  /// something that cannot vary; ContractError if a stroke is open already.
  /// `path`: places of the surface where the stroke will go, in order, object units; there and at the images
  /// of symmetry the surface is refined at once, as StrokeSettings::refining says, with the stroke as one
  /// step of undo. Throws Error where that would take more than 10 million triangles.
  /// `later`: the strokes that will follow, asked for, until the stroke ends, only if the surface is refined
  /// along the path, or if its end takes out what finer strokes refined. The surface is then refined for
  /// those too that need edges of the same length, one after the other as long as bounds allow, since each
  /// refinement costs in proportion to the whole surface; and what they need is not taken out.
  void begin_stroke(const StrokeSettings& settings, std::span<const Vec3d> path = {},
                    const LaterStrokes& later = {});

  /// Adds a sample at the first intersection of a ray with the surface, or at the surface point closest to a
  /// position, at most one radius away; object units. `time` is in seconds and must not decrease; several
  /// samples with the same time stamp should be given distinct times first, see spread_times(). Throws Error
  /// if the brush fails or returns a value that is not finite; ContractError if no stroke is open, if the
  /// time decreases, or if the pen has a value in a field that StrokeSettings::fields does not announce, such
  /// as a pressure other than 1.
  StrokeEvent add_sample(const Ray& ray, double time, const Pen& pen, Show show = Show::now);
  StrokeEvent add_sample(const Vec3d& position, double time, const Pen& pen, Show show = Show::now);

  /// Ends a piece of the open stroke, when the pen left the surface or jumped over a gap. The next sample
  /// starts another piece with its own curve and chart. All pieces start from the surface before the stroke.
  /// Where they overlap, their nodes are sheets of one stroke, and later pieces count as drawn later. They
  /// are undone together. The piece may close as in end_stroke(). Returns the vertices that changed, as
  /// StrokeEvent::changed; valid until the next call.
  std::span<const Index> end_piece(Closure closure = Closure::open);

  /// Ends the open stroke and makes it part of the surface. A stroke without a sample has no effect and
  /// cannot be undone. Strokes are open while they are drawn; here the stroke may become closed, which
  /// changes all of it. curve().closed tells whether it did; CurveTracer::closed_curve() documents the
  /// conditions. Returns the vertices that changed, as StrokeEvent::changed; all where generation()
  /// changes: where the stroke merged a solid with the surface, refined it to an error, or took out vertices
  /// that strokes with shorter edges added and it does not need; valid until the next call. Throws Error
  /// where a solid cannot be merged, or that would take more than 10 million triangles.
  std::span<const Index> end_stroke(Closure closure = Closure::open);

  /// Drops the open stroke, if there is one. changed() then lists the vertices that returned to their
  /// previous state.
  void cancel_stroke();

  /// The vertices that the last non-const call changed, as StrokeEvent::changed; after undo(), redo(),
  /// cancel_stroke() and calls that threw as well. set_paint() may change all vertices and is not reported
  /// here. Valid until the next call.
  std::span<const Index> changed() const;

  /// The chart and the curve of the last piece of the open stroke, or of the last stroke; the chart is empty
  /// after generation() has changed.
  const Chart& chart() const;
  const SurfaceCurve& curve() const;  ///< of that piece

  /// Undoes the last finished stroke exactly, to the bit. Returns false if there is none. Throws
  /// ContractError if a stroke is open.
  bool undo();

  /// Makes the stroke that was undone last again, to the bit, without drawing it. Returns false if there is
  /// none, as after another stroke. Throws ContractError if a stroke is open.
  bool redo();

  /// How many strokes can be undone, and how many made again.
  std::size_t undo_count() const;
  std::size_t redo_count() const;

  /// Bounds what undo and redo may hold, now and whenever a stroke is finished: while it is more, the oldest
  /// stroke can no longer be undone. Without a bound all can.
  void limit_undo(std::size_t bytes);
  std::size_t undo_bytes() const;    ///< what both hold
  std::size_t undo_dropped() const;  ///< how many strokes the bound has cost so far

  /// Takes the step of the last finished stroke, so that the application can hold, save and drop it; undo()
  /// knows of that stroke no more. Returns nothing if there is none. Throws Error for a stroke that made
  /// triangles or parts, whose step stays; ContractError if a stroke is open. The first call costs
  /// O(vertices), others what the stroke changed.
  std::optional<StrokeStep> take_step();

  /// Undoes the stroke of a step, or makes it again: its vertices take the values that the step has, and the
  /// step then has those that they had, for the other way. To the bit. changed() lists the vertices. The
  /// step may come from another session of the same mesh. Steps that the session itself holds undo their
  /// vertices to where they were before their strokes, whatever was applied since. Throws Error, and changes
  /// nothing, unless all positions, colours and masks are as they were when the step was taken or applied
  /// last; ContractError if a stroke is open.
  void apply(StrokeStep& step);

  /// The cost of the last non-const call (cancel_stroke() does not count).
  const EventCost& cost() const;

  /// XXH3 hash of the current positions, and of colours, masks, parts and bent meshes if there are any, in
  /// the vertex order of the original mesh.
  std::uint64_t result_hash() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
