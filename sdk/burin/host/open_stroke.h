#pragma once
#include <burin/chart/stroke_chart.h>
#include <burin/deform/brush_stroke.h>
#include <burin/deform/evaluate.h>
#include <burin/deform/stroke_changes.h>
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

/// The stroke that a session is drawing. Surface, picker, brush and descriptor must outlive it. Functions
/// that throw leave nodes and moves unspoken for: the stroke is to be dropped.
class OpenStroke {
 public:
  /// Begins a stroke of the brush. Throws Error as Session::begin_stroke.
  OpenStroke(const Surface& surface, const Picker& picker, const burin_brush& brush,
             const burin_brush_descriptor& descriptor, const StrokeSettings& settings);

  bool empty() const { return tracer_.curve().points.empty(); }
  double radius() const { return settings_.radius; }
  const Chart& chart() const { return nodes_.chart; }
  const SurfaceCurve& curve() const { return closed_curve_ ? *closed_curve_ : tracer_.curve(); }

  /// Whether the stroke so far can go on at this place.
  bool connects(const SurfacePoint& at) const { return empty() || tracer_.connects(at); }

  /// Draws on to `at`. Vertices that leave the chart go back to their base.
  VertexMoves add(const SurfacePoint& at, double time, const Pen& pen, StrokeCharter& charter,
                  Evaluator& evaluator, StageClock& clock);

  /// The last evaluation: what depends on the stroke's length, told that it is final; all of it when the
  /// stroke closes.
  VertexMoves finish(Closure closure, StrokeCharter& charter, Evaluator& evaluator, StageClock& clock);

 private:
  ChartOptions chart_options() const {
    return {.radius = settings_.radius, .cap = settings_.cap, .join = settings_.join};
  }
  bool width_varies() const { return settings_.pressure_width > 0 && settings_.fields.pressure; }
  burin_stroke_context context(std::uint64_t flags) const;
  StrokeNodes make_nodes(Chart chart) const;
  VertexMoves go_on_to(StrokeNodes nodes, double end_zone, std::uint64_t flags, Evaluator& evaluator,
                       StageClock& clock);
  void evaluate(const StrokeNodes& nodes, const StrokeChanges& changes, std::uint64_t flags,
                Evaluator& evaluator);
  VertexMoves moves(const StrokeChanges& changes) const;

  const Surface* surface_;
  StrokeSettings settings_;
  ParamSnapshot params_;
  CurveTracer tracer_;
  std::optional<SurfaceCurve> closed_curve_;  ///< once the stroke is finished as a closed one
  BrushStroke brush_stroke_;
  double last_time_;
  StrokeNodes nodes_;
  std::vector<Vec3f> displacement_;  ///< [node] of nodes_, in its (e1, e2, n)
};

}  // namespace burin
