#pragma once
#include <burin/deform/accumulation.h>
#include <burin/deform/blend/earlier_pieces.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/stroke_passes.h>
#include <burin/host/event_cost.h>
#include <burin/host/plugin/param_snapshot.h>
#include <burin/host/session/stroke_instance.h>
#include <burin/host/stroke_settings.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace burin {

/// What an event does to vertices, each named once.
struct VertexMoves {
  std::vector<Index> vertices;
  std::vector<Vec3f> places;  ///< where they go: [i] of vertices[i]
  std::vector<Tint> tints;    ///< the same of colours and masks; empty where the brush writes none
};

/// What strokes need that sessions keep from one to the next. Looked at, not owned.
struct StrokeTools {
  Evaluator& evaluator;
  const Paint& paint;  ///< of the surface when the stroke began
  EventCost& cost;
  StageClock& clock;
};

/// The stroke that a session is drawing, piece by piece and in all its symmetric images. Surface, picker,
/// builders, brush and descriptor must outlive it, and the builders serve no other. Functions that throw
/// leave nodes and moves unspoken for: the stroke is to be dropped.
class OpenStroke {
 public:
  /// Begins a stroke of the brush. Throws Error as Session::begin_stroke.
  OpenStroke(const Surface& surface, const Picker& picker, ChartBuilders& builders, const burin_brush& brush,
             const burin_brush_descriptor& descriptor, const StrokeSettings& settings);

  /// Whether no piece of it has a sample.
  bool empty() const { return earlier_.count() == 0 && piece_empty(); }
  bool piece_empty() const { return drawn_by_hand().empty(); }
  double radius() const { return settings_.radius; }
  const SurfaceCurve& curve() const { return drawn_by_hand().curve(); }
  const LiveChart& live() const { return drawn_by_hand().live(); }
  const burin_brush_descriptor& brush() const { return brush_stroke_.descriptor(); }

  /// Whether the stroke so far can go on at this place.
  bool connects(const CurveGround::Place& at) const { return drawn_by_hand().connects(at); }

  /// Where the stroke as drawn by hand runs.
  const CurveGround& ground() const { return drawn_by_hand().ground(); }

  /// Leads the curve on to `at`, and those of the images to theirs. An image that meets no surface, or only
  /// across a gap, stays where it is.
  void trace(const CurveGround::Place& at, double time, const Pen& pen);

  /// Draws what was traced since the last time. Vertices that leave the chart go back to their base.
  VertexMoves draw(const StrokeTools& tools);

  /// The last evaluation of a piece that is not empty: what depends on its length, told that it is final; all
  /// of it when the piece closes.
  VertexMoves finish(Closure closure, const StrokeTools& tools);

  /// Keeps the piece, which is finished, as one of those before, until begin_piece().
  void keep_piece();
  bool piece_kept() const { return piece_kept_; }

  /// Begins another, whose chart starts anew, from the surface before the stroke.
  void begin_piece();

 private:
  const StrokeInstance& drawn_by_hand() const { return instances_.front(); }
  void begin_instances();
  void accumulate();
  void look_around();
  bool passes_look_around() const;
  burin_stroke_context context(std::uint64_t flags, const SurfaceCurve& curve) const;
  BlendOptions blend_options() const;
  VertexMoves go_on(const std::vector<StrokeChanges>& changes, std::uint64_t flags, const StrokeTools& tools);
  void evaluate(const std::vector<StrokeChanges>& changes, std::uint64_t flags, const StrokeTools& tools,
                std::vector<Index>& vertices);
  VertexMoves blend(std::vector<Index> vertices, const Paint& paint) const;
  std::vector<InstanceSheets> piece_sheets() const;

  const Surface* surface_;
  const Picker* picker_;
  ChartBuilders* builders_;
  StrokeSettings settings_;
  ParamSnapshot params_;
  double narrowest_;  ///< width that the stroke may have, a share of its radius
  BrushStroke brush_stroke_;
  std::vector<SymmetryInstance> images_;
  std::deque<StrokeInstance> instances_;
  std::optional<StrokePasses> passes_;        ///< of brushes whose passes look at neighbours
  std::optional<Accumulation> accumulation_;  ///< of strokes that go on from what they made themselves
  EarlierPieces earlier_;
  bool piece_kept_ = false;  ///< and no other has begun
  double last_time_;
};

}  // namespace burin
