#pragma once
#include <burin/base/error.h>
#include <burin/chart/chart.h>
#include <burin/deform/paint.h>
#include <burin/host/brush_library.h>
#include <burin/host/event_cost.h>
#include <burin/host/stroke_settings.h>
#include <burin/stroke/curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <memory>
#include <span>

namespace burin {

/// When a sample is to be seen. A stroke is the same whenever that is; who shows fewer samples pays for
/// fewer.
enum class Show {
  now,
  later,  ///< with the next sample that is shown, or at the end: for samples that come several at a time
};

/// What became of one sample.
struct StrokeEvent {
  enum class Outcome {
    drawn,         ///< the stroke now reaches to the sample, though it may be shown later
    off_surface,   ///< the ray misses, or nothing is near the place: nothing changed
    disconnected,  ///< on the surface, but across a gap or silhouette: nothing changed
  };
  Outcome outcome = Outcome::off_surface;
  /// Vertices that moved and their neighbours, whose normals may have changed, and those of another colour or
  /// mask; ascending. Valid until the next call.
  std::span<const Index> changed;
};

/// A surface being sculpted: the one class that an embedding application needs. Strokes are drawn one at
/// a time, sample by sample; a stroke sees the surface as it was when the stroke began. Vertex numbers are
/// those of surface(). One thread; it uses all threads of oneTBB inside.
/// A call that throws leaves the surface as it was before the stroke, and no stroke open.
class Session {
 public:
  /// `brushes` must outlive the session. Throws ContractError for a point set: normals of moved points would
  /// need triangles.
  Session(Surface surface, const BrushLibrary& brushes);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// The surface as of the last finished stroke. Its arrays stay in place.
  const Surface& surface() const;
  const Picker& picker() const;

  /// What is to be shown now, the open stroke included; [vertex].
  std::span<const Vec3f> positions() const;
  std::span<const Vec3f> normals() const;

  /// Colours and masks, the open stroke included; [vertex] of arrays that are not empty.
  const Paint& paint() const;

  /// Starts from these colours and masks. Not while a stroke is open, and not to be undone. Throws
  /// ContractError for arrays that are neither empty nor of an element a vertex, or values outside of 0..1.
  void set_paint(Paint paint);

  /// Opens a stroke. Throws Error: unknown brush or parameter, a value out of its range, a file that
  /// cannot be read, a brush that reads what this host does not offer, a dynamic of what does not vary.
  void begin_stroke(const StrokeSettings& settings);

  /// The next sample: where a ray meets the surface, or the closest place to a point that is at most one
  /// radius away. Times must not fall; samples that come several at a time and have one time stamp should be
  /// given times of their own first, see spread_times(). Throws Error when the brush fails or returns a value
  /// that is not finite; ContractError for a time that falls, and for a pen that is not as
  /// StrokeSettings::fields has it: pressure other than 1, say, of a pen that reports none.
  StrokeEvent add_sample(const Ray& ray, double time, const Pen& pen, Show show = Show::now);
  StrokeEvent add_sample(const Vec3d& position, double time, const Pen& pen, Show show = Show::now);

  /// Ends a piece of the open stroke, for a pen that left the surface or jumped over a gap: the next sample
  /// begins another, with a curve and a chart of its own. All pieces start from the surface before the
  /// stroke, and where they overlap they are sheets of one stroke; those of later pieces are the later ones.
  /// They are undone together. Closes as end_stroke() does. Returns the vertices that the end changed, as
  /// that.
  std::span<const Index> end_piece(Closure closure = Closure::open);

  /// Ends the open stroke and makes it part of the surface. A stroke without a sample leaves no trace.
  /// While the pen is down strokes are open; here one may become closed, so that all of it changes:
  /// curve().closed says whether it did, CurveTracer::closed_curve() under which conditions.
  /// Returns the vertices that the end changed, as StrokeEvent::changed, valid until the next call.
  std::span<const Index> end_stroke(Closure closure = Closure::open);

  /// Drops the open stroke, if there is one: changed() are the vertices that are shown as before it again.
  void cancel_stroke();

  /// Vertices that the last call of a function that is not const changed, as StrokeEvent::changed: those of
  /// undo() and cancel_stroke(), and those of a stroke that was dropped since the call threw. Valid until the
  /// next call. set_paint() may change all, and is not told here.
  std::span<const Index> changed() const;

  /// The chart of the open stroke, or of the last one; of its last piece.
  const Chart& chart() const;
  const SurfaceCurve& curve() const;

  /// Takes back the last finished stroke bit for bit; false when there is none. Not while one is open.
  bool undo();

  /// Of the last add_sample, end_stroke or undo.
  const EventCost& cost() const;

  /// XXH3 of the shown positions, and of colours and masks where there are any, in the order of the mesh that
  /// the surface was made of.
  std::uint64_t result_hash() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
