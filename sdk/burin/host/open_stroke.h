#pragma once
#include <burin/chart/stroke_chart.h>
#include <burin/deform/brush_stroke.h>
#include <burin/deform/evaluate.h>
#include <burin/deform/param_dynamics.h>
#include <burin/deform/stroke_nodes.h>
#include <burin/host/event_cost.h>
#include <burin/host/param_snapshot.h>
#include <burin/host/session.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// Vertices, each once, and where they go.
struct VertexMoves {
  std::vector<Index> vertices;
  std::vector<Vec3f> places;  ///< [i] of vertices[i]
};

/// What strokes need that sessions keep from one to the next. Looked at, not owned.
struct StrokeTools {
  StrokeCharter& charter;
  Evaluator& evaluator;
  EventCost& cost;
  StageClock& clock;
};

/// The stroke that a session is drawing. Surface, picker, charter, brush and descriptor must outlive it, and
/// the charter serves no other. Functions that throw leave nodes and moves unspoken for: the stroke is to be
/// dropped.
class OpenStroke {
 public:
  /// Begins a stroke of the brush. Throws Error as Session::begin_stroke.
  OpenStroke(const Surface& surface, const Picker& picker, StrokeCharter& charter, const burin_brush& brush,
             const burin_brush_descriptor& descriptor, const StrokeSettings& settings);

  bool empty() const { return tracer_.curve().points.empty(); }
  double radius() const { return settings_.radius; }
  const SurfaceCurve& curve() const { return closed_curve_ ? *closed_curve_ : tracer_.curve(); }

  /// Whether the stroke so far can go on at this place.
  bool connects(const SurfacePoint& at) const { return empty() || tracer_.connects(at); }

  /// Leads the curve on to `at`.
  void trace(const SurfacePoint& at, double time, const Pen& pen);

  /// Draws what was traced since the last time. Vertices that leave the chart go back to their base.
  VertexMoves draw(const StrokeTools& tools);

  /// The last evaluation: what depends on the stroke's length, told that it is final; all of it when the
  /// stroke closes.
  VertexMoves finish(Closure closure, const StrokeTools& tools);

 private:
  ChartOptions chart_options() const {
    return {.radius = settings_.radius, .cap = settings_.cap, .join = settings_.join};
  }
  DrivenStroke driven_stroke() const { return {settings_.fields, settings_.radius, settings_.seed}; }
  burin_stroke_context context(std::uint64_t flags) const;
  ReadInputs read_inputs() const;
  VertexMoves draw_traced(std::uint64_t flags, const StrokeTools& tools);
  void chart(const StrokeTools& tools, std::size_t unchanged);
  VertexMoves go_on(const StrokeChanges& changes, std::uint64_t flags, const StrokeTools& tools);

  const Surface* surface_;
  StrokeSettings settings_;
  ParamSnapshot params_;
  StrokeWidth width_;
  ParamDynamics dynamics_;
  CurveTracer tracer_;
  std::optional<SurfaceCurve> closed_curve_;  ///< once the stroke is finished as a closed one
  BrushStroke brush_stroke_;
  double last_time_;
  std::size_t drawn_points_ = 0;  ///< of the curve, that nothing traced since was drawn can change
  double drawn_length_ = 0;
  bool traced_ = false;  ///< and not drawn yet
  StrokeNodes nodes_;
  std::vector<Vec3f> displacement_;  ///< [slot] of nodes_, in its (e1, e2, n)
};

}  // namespace burin
