#pragma once
#include <burin/chart/dabs/live_dabs.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/param_dynamics.h>
#include <burin/deform/evaluate/stroke_nodes.h>
#include <burin/deform/stroke_passes.h>
#include <burin/host/event_cost.h>
#include <burin/host/session/image_chart.h>
#include <burin/host/stroke_settings.h>
#include <burin/stroke/curve/foot_line.h>
#include <burin/stroke/symmetry.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

namespace burin {

/// What charts one instance of a stroke, kept from stroke to stroke.
struct InstanceChartBuilders {
  StrokeChartBuilder stroke;
  std::unique_ptr<LiveDabs> dabs;    ///< once a stroke of dabs was drawn
  std::unique_ptr<LiveChart> image;  ///< once it was the image of another
};

/// ChartBuilders of a surface, made when a stroke first needs them, and the levels that they share.
class ChartBuilders {
 public:
  ChartBuilders(const Surface& surface, const Picker& picker)
      : surface_(&surface), picker_(&picker), levels_(surface) {}

  InstanceChartBuilders& operator[](std::size_t instance);

  /// Follows the surface after these vertices moved, by at most `distance`.
  void moved(std::span<const Index> vertices, double distance);
  LiveDabs& dabs(std::size_t instance);

  /// Where the chart of an image is to be; empty.
  LiveChart& image(std::size_t instance);

 private:
  const Surface* surface_;
  const Picker* picker_;
  SurfaceLevels levels_;
  std::deque<InstanceChartBuilders> builders_;
};

/// One symmetric image of a stroke that is being drawn: its curve, its chart, and what the brush does there.
class StrokeInstance {
 public:
  /// `original`: the stroke as drawn by hand, which must outlive its images and be drawn and finished before
  /// them each time; null: this is it. Throws Error for dynamics that the brush does not take.
  StrokeInstance(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                 const StrokeSettings& settings, const SymmetryInstance& image, const BrushStroke& brush,
                 const StrokeInstance* original);
  StrokeInstance(const StrokeInstance&) = delete;
  StrokeInstance& operator=(const StrokeInstance&) = delete;

  const SymmetryInstance& image() const { return image_; }
  bool empty() const { return tracer_.curve().points.empty(); }
  const SurfaceCurve& curve() const { return closed_curve_ ? *closed_curve_ : tracer_.curve(); }
  const LiveChart& live() const { return image_chart_ ? image_chart_->live() : own_live(); }
  NodeOutputs& outputs() { return outputs_; }
  /// What is to be blended. Valid until the next event.
  InstanceSheets sheets() const { return {&live(), &outputs_, nodes_->half_width(), dab_t()}; }

  /// Whether the stroke so far can go on at this place.
  bool connects(const CurveGround::Place& at) const { return empty() || tracer_.connects(at); }

  const CurveGround& ground() const { return tracer_.ground(); }

  /// Leads the curve on to `at`.
  void trace(const CurveGround::Place& at, double time, const Pen& pen);

  /// Whether something was traced since the last time that the brush can see.
  bool has_news() const { return traced_; }

  /// Charts what was traced since the last time, and says what is stale. `end_influence`: of the brush.
  StrokeChanges draw(double end_influence, EventCost& cost);

  /// Once the pen is up, after close(): draws what is left, or all of it where the stroke closed. `news`:
  /// whether this or another image has some.
  StrokeChanges finish(bool news, double end_influence, EventCost& cost);

  /// Decides whether the stroke closes.
  void close(Closure closure) { closed_curve_ = tracer_.closed_curve(closure); }

  /// What its nodes stand on. `paint`: of the surface.
  NodeSource source(const Paint& paint) const;

 private:
  CurveGround begun(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                    const StrokeSettings& settings, const SymmetryInstance& image);
  ReadInputs read_inputs(const StrokeSettings& settings, std::uint64_t inputs) const;
  const LiveChart& own_live() const { return dabs_ ? dabs_->live() : builder_->live(); }
  std::span<const float> dab_t() const;
  bool runs_like_original() const;
  void chart(std::size_t unchanged, EventCost& cost);
  void chart_own(std::size_t unchanged, EventCost& cost);
  double other_feet_from(double same_curve_up_to) const;
  bool reads_foot() const { return reads_.inputs & BURIN_INPUT_FOOT; }

  const Surface* surface_;
  SymmetryInstance image_;
  StrokeWidth width_;
  ParamDynamics dynamics_;
  ReadInputs reads_;
  StrokeChartBuilder* builder_ = nullptr;
  BaseSurface* base_ = nullptr;  ///< that the stroke runs on, instead of the surface itself
  LiveDabs* dabs_ = nullptr;     ///< instead of the builder, in strokes of dabs
  const StrokeInstance* original_;
  std::optional<ImageChart> image_chart_;  ///< of images of another
  CurveTracer tracer_;
  std::optional<SurfaceCurve> closed_curve_;  ///< once the stroke is finished as a closed one
  std::optional<FootLine> foot_;
  std::size_t drawn_points_ = 0;  ///< of the curve, that nothing traced since was drawn can change
  double drawn_length_ = 0;
  bool traced_ = false;  ///< and not drawn yet
  std::optional<StrokeNodes> nodes_;
  NodeOutputs outputs_;  ///< [slot]
};

}  // namespace burin
