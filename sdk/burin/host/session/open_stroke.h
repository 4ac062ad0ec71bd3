#pragma once
#include <burin/along/along_parts.h>
#include <burin/deform/accumulation.h>
#include <burin/deform/blend/earlier_pieces.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/curve_filter.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/solid/solid_stroke.h>
#include <burin/deform/stroke_passes.h>
#include <burin/host/event_cost.h>
#include <burin/host/plugin/param_snapshot.h>
#include <burin/host/session/stroke_instance.h>
#include <burin/host/session/vertex_moves.h>
#include <burin/stroke/stroke_settings.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Objects that a session keeps from stroke to stroke. Non-owning.
struct StrokeTools {
  Evaluator& evaluator;
  const Paint& paint;  ///< colours and masks before the stroke
  EventCost& cost;
  StageClock& clock;
  const Progress& progress;  ///< of making solids
};

/// The open stroke of a session, with all its pieces and symmetric images. Surface, picker, chart builders,
/// brush and descriptor must outlive the object, and no other stroke may use the chart builders. A function
/// that throws leaves the stroke in an unspecified state; drop it.
class OpenStroke {
 public:
  /// Starts a stroke of the brush. Throws Error as Session::begin_stroke().
  OpenStroke(const Surface& surface, const Picker& picker, ChartBuilders& builders, const burin_brush& brush,
             const burin_brush_descriptor& descriptor, const StrokeSettings& settings);

  /// Whether no piece has a sample.
  bool empty() const { return earlier_.count() == 0 && !solid_ && !bent_ && piece_empty(); }
  bool piece_empty() const { return primary_instance().empty(); }
  double radius() const { return settings_.radius; }
  const SurfaceCurve& curve() const { return primary_instance().curve(); }
  const LiveChart& live() const { return primary_instance().live(); }
  const burin_brush_descriptor& brush() const { return brush_stroke_.descriptor(); }

  /// Whether the current piece can continue at this point.
  bool connects(const CurveGround::Point& at) const { return primary_instance().connects(at); }

  /// The ground on which the stroke as drawn by hand runs.
  const CurveGround& ground() const { return primary_instance().ground(); }

  /// Extends the curve to `at`, and the curves of the images to the images of `at`. An image whose next point
  /// is not on the surface, or across a gap, is not extended. Throws ContractError for a time that falls and
  /// for pen values that the settings do not announce.
  void trace(const CurveGround::Point& at, double time, const Pen& pen);

  /// Draws what was traced since the last call. Vertices that leave the chart return to their original
  /// positions.
  VertexMoves draw(const StrokeTools& tools);

  /// Evaluates a piece that is not empty for the last time: the nodes that depend on its length, which is now
  /// final, or all nodes if the piece closes.
  VertexMoves finish(Closure closure, const StrokeTools& tools);

  /// Of a stroke that makes a solid, what its finished pieces have made, if anything.
  std::optional<StrokeSolid>& solid() { return solid_; }

  /// Of a stroke that bends meshes along itself, what its finished pieces have made, if anything.
  std::optional<TriangleMesh>& bent() { return bent_; }

  /// How the surface takes in what the finished pieces have made, if it does. Refers to the stroke.
  std::optional<SolidMerge> merge() const;

  /// What its author should know of what the brush has done, a line each.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Wall time that making solids and meshes has taken, seconds.
  double solid_seconds() const { return solid_seconds_; }

  /// Stores the finished piece with the earlier ones. begin_piece() must follow before the next sample.
  void keep_piece();
  bool piece_kept() const { return piece_kept_; }

  /// Starts another piece with a new chart, from the surface before the stroke.
  void begin_piece();

 private:
  const StrokeInstance& primary_instance() const { return instances_.front(); }
  bool makes_solid() const;
  bool makes_part() const { return solid_stroke_ || along_; }
  void begin_instances();
  void accumulate();
  void set_up_passes();
  bool passes_read_neighbours() const;
  burin_stroke_context context(std::uint64_t flags, const SurfaceCurve& curve) const;
  BlendOptions blend_options() const;
  VertexMoves evaluate_and_blend(const std::vector<StrokeChanges>& changes, std::uint64_t flags,
                                 const StrokeTools& tools);
  void evaluate(const std::vector<StrokeChanges>& changes, std::uint64_t flags, const StrokeTools& tools,
                std::vector<Index>& vertices);
  VertexMoves blend(std::vector<Index> vertices, const Paint& paint) const;
  std::vector<InstanceSheets> piece_sheets() const;
  void make_solid(const StrokeTools& tools);
  void check_slope(const StrokeSolid& made);
  void bend_meshes(const Paint& paint);
  double mesh_voxel() const;

  const Surface* surface_;
  const Picker* picker_;
  ChartBuilders* builders_;
  StrokeSettings settings_;
  ParamSnapshot params_;
  double narrowest_;  ///< least half width that the stroke may have, as a share of its radius
  BrushStroke brush_stroke_;
  std::optional<CurveFilter> curve_filter_;  ///< of brushes that move the curve
  std::vector<SymmetryInstance> images_;
  std::deque<StrokeInstance> instances_;
  std::optional<StrokePasses> passes_;        ///< set for brushes whose passes read neighbours
  std::optional<Accumulation> accumulation_;  ///< set for strokes that accumulate on their own result
  EarlierPieces earlier_;
  std::optional<SolidStroke> solid_stroke_;  ///< of strokes that make a solid, instead of all else
  std::optional<StrokeSolid> solid_;
  SolidOperation solid_operation_ = SolidOperation::none;
  std::optional<AlongParts> along_;  ///< of strokes that bend meshes along themselves, instead of all else
  std::optional<TriangleMesh> bent_;
  double solid_seconds_ = 0;
  std::vector<std::string> warnings_;
  bool piece_kept_ = false;  ///< the current piece was kept, and no other was started
  double last_time_;
};

}  // namespace burin
