#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/front/front.h>
#include <burin/chart/joins/leg_charts.h>
#include <burin/chart/live_chart.h>
#include <burin/chart/transfer/leg_transfer.h>

#include <cstddef>
#include <optional>

namespace burin {

/// Computes stroke charts on one ground: by one front for open strokes with round joins, by several legs that
/// are put together for closed strokes and other joins. One thread at a time.
class GroundChartBuilder {
 public:
  /// The ground's surface must outlive the object.
  explicit GroundChartBuilder(const ChartGround& ground)
      : ground_(ground), front_(ground), live_(ground.vertex_count()) {}

  /// Starts a stroke. The radius must be finite and above 0. `follow` is ignored: the ground already reflects
  /// it.
  void begin(const ChartOptions& options) { begin(options, options.radius); }

  /// Starts a stroke whose own half width `stroke_radius`, object units, at most that of the chart, decides
  /// where it is cut into legs.
  void begin(const ChartOptions& options, double stroke_radius);

  /// Extends the chart to this curve; the result equals that of a fresh start bit for bit. The first
  /// `unchanged` points are those of the curve before. `parts` is the number of parts of a fresh front.
  Chart update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts);

  /// Does what update() does, but the result is kept from event to event, and an event costs only what it
  /// changes.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged);

  const LiveChart& live() const { return live_; }

  /// Whether one front charts this curve; otherwise it is put together from legs.
  bool in_one_piece(const SurfaceCurve& curve) const { return options_.join == Join::round && !curve.closed; }

  /// Charts the legs of this curve instead of update() or draw(), and does not join them. Valid until the
  /// next call.
  const LegCharts& draw_legs(const SurfaceCurve& curve, std::size_t unchanged);

  /// The stroke of the last chart in one piece.
  const FrontStroke& stroke() const { return front_.stroke(); }
  std::uint64_t settled() const { return legs_ ? legs_->settled() : front_.settled(); }
  std::uint64_t pushes() const { return legs_ ? legs_->pushes() : front_.pushes(); }

 private:
  void expect_curve(const SurfaceCurve& curve) const;
  void goes_in_one_piece();
  const LiveChart& draw_joined(const SurfaceCurve& curve, std::size_t unchanged);
  Chart plain(const SurfaceCurve& curve);

  ChartGround ground_;
  ChartOptions options_;
  double stroke_radius_ = 0;
  Front front_;
  std::optional<LegCharts> legs_;      ///< set while the stroke is made of legs
  std::optional<LegTransfer> joined_;  ///< joins them on the vertices themselves
  LiveChart live_;
};

/// The number of parts into which the front of this curve is cut: 1 for small charts, at most one per thread.
std::size_t parts_for(const SurfaceCurve& curve, double radius);

}  // namespace burin
