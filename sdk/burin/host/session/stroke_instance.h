#pragma once
#include <burin/chart/dabs/live_dabs.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/curve_filter.h>
#include <burin/deform/evaluate/param_dynamics.h>
#include <burin/deform/evaluate/stroke_nodes.h>
#include <burin/deform/stroke_passes.h>
#include <burin/host/event_cost.h>
#include <burin/host/session/image_chart.h>
#include <burin/stroke/curve/end_distances.h>
#include <burin/stroke/curve/foot_line.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/stroke/symmetry.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

namespace burin {

/// The objects that chart one instance of a stroke, kept from stroke to stroke.
struct InstanceChartBuilders {
  StrokeChartBuilder stroke;
  std::unique_ptr<LiveDabs> dabs;    ///< created for the first stroke of dabs
  std::unique_ptr<LiveChart> image;  ///< created when the instance is first an image of another
};

/// The chart builders of a surface, created when a stroke first needs them, and the levels that they share.
/// Surface and picker must outlive the object.
class ChartBuilders {
 public:
  ChartBuilders(const Surface& surface, const Picker& picker)
      : surface_(&surface), picker_(&picker), levels_(surface) {}

  InstanceChartBuilders& operator[](std::size_t instance);

  /// Updates levels and base surfaces after these vertices moved, by at most `distance`, object units.
  void moved(std::span<const Index> vertices, double distance);

  /// Frees what is only of use to the next stroke; the levels stay.
  void free_strokes() { builders_.clear(); }
  LiveDabs& dabs(std::size_t instance);

  /// An empty chart that receives the nodes of an image.
  LiveChart& image(std::size_t instance);

 private:
  const Surface* surface_;
  const Picker* picker_;
  SurfaceLevels levels_;
  std::deque<InstanceChartBuilders> builders_;
};

/// One symmetric image of the open stroke: its curve, its chart, and the outputs of the brush.
class StrokeInstance {
 public:
  /// `original` is the stroke as drawn by hand, or null if this is it. The original must outlive its images
  /// and be drawn and finished before them in every event. `filter` is what the brush does to curves, or
  /// null, and must outlive the object. Throws Error for dynamics that the brush does not support.
  StrokeInstance(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                 const StrokeSettings& settings, const SymmetryInstance& image, const BrushStroke& brush,
                 const CurveFilter* filter, const StrokeInstance* original);
  StrokeInstance(const StrokeInstance&) = delete;
  StrokeInstance& operator=(const StrokeInstance&) = delete;

  const SymmetryInstance& image() const { return image_; }
  bool empty() const { return tracer_.curve().points.empty(); }
  /// The curve that is charted: the drawn one, or what the brush makes of it.
  const SurfaceCurve& curve() const { return moved_ ? moved_->curve() : drawn(); }
  const LiveChart& live() const { return image_chart_ ? image_chart_->live() : own_live(); }
  NodeOutputs& outputs() { return outputs_; }
  /// The nodes and outputs to blend. Valid until the next event.
  InstanceSheets sheets() const { return {&live(), &outputs_, nodes_->half_width(), dab_t()}; }

  /// Whether the curve can continue at this point.
  bool connects(const CurveGround::Point& at) const { return empty() || tracer_.connects(at); }

  const CurveGround& ground() const { return tracer_.ground(); }

  /// Extends the curve to `at`.
  void trace(const CurveGround::Point& at, double time, const Pen& pen);

  /// Whether anything that influences the brush was traced since the last draw().
  bool has_changes() const { return traced_; }

  /// Charts what was traced since the last draw(), and returns the stale nodes.
  StrokeChanges draw(EventCost& cost) { return draw(0, cost); }

  /// Draws what remains when the pen is up, after close(): all of the stroke if it closed. `news` tells
  /// whether any image has_changes().
  StrokeChanges finish(bool news, EventCost& cost);

  /// Decides whether the stroke closes.
  void close(Closure closure) { closed_curve_ = tracer_.closed_curve(closure); }

  /// The source of the nodes' inputs. `paint` holds colours and masks before the stroke.
  NodeSource source(const Paint& paint) const;

 private:
  CurveGround begun(const Surface& surface, const Picker& picker, ChartBuilders& builders,
                    const StrokeSettings& settings, const SymmetryInstance& image);
  ReadInputs read_inputs(const StrokeSettings& settings, std::uint64_t inputs) const;
  StrokeChanges draw(std::uint64_t flags, EventCost& cost);
  const SurfaceCurve& drawn() const { return closed_curve_ ? *closed_curve_ : tracer_.curve(); }
  void begin_moving();
  void move_curve(std::uint64_t flags);
  const LiveChart& own_live() const { return dabs_ ? dabs_->live() : builder_->live(); }
  std::span<const float> dab_t() const;
  bool runs_like_original() const;
  void chart(std::size_t unchanged, EventCost& cost);
  void look_along();
  void chart_own(std::size_t unchanged, EventCost& cost);
  double other_feet_from(double same_curve_up_to) const;
  StrokeEnds ends(double same_curve_up_to);
  bool reads_foot() const { return reads_.inputs & BURIN_INPUT_FOOT; }
  bool reads_end_distance() const { return reads_.inputs & BURIN_INPUT_END_DISTANCE; }

  const Surface* surface_;
  SymmetryInstance image_;
  StrokeWidth width_;
  ParamDynamics dynamics_;
  ReadInputs reads_;
  double end_influence_;  ///< distance from the end within which the brush depends on the length
  StrokeChartBuilder* builder_ = nullptr;
  BaseSurface* base_ = nullptr;  ///< the base surface on which the stroke runs; null: the surface itself
  LiveDabs* dabs_ = nullptr;     ///< set instead of the chart builder in strokes of dabs
  const CurveFilter* filter_;
  const StrokeInstance* original_;
  std::optional<ImageChart> image_chart_;  ///< set if this is an image of another instance
  CurveTracer tracer_;
  std::optional<SurfaceCurve> closed_curve_;  ///< set when the stroke was finished as a closed one
  /// Set where the brush moves curves; if it must know all of a curve for that, only when it is finished.
  std::optional<MovedCurve> moved_;
  std::optional<FootLine> foot_;
  std::optional<EndDistances> ends_;
  bool begin_bent_ = false;       ///< EndDistances::begin_bends() at the last event
  std::size_t drawn_points_ = 0;  ///< number of drawn points of the curve that are final
  double drawn_length_ = 0;
  bool traced_ = false;  ///< something was traced and not drawn yet
  std::optional<StrokeNodes> nodes_;
  NodeOutputs outputs_;  ///< [slot]
};

}  // namespace burin
