#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/front/front.h>
#include <burin/chart/joins/joined_legs.h>
#include <burin/chart/live_chart.h>

#include <cstddef>

namespace burin {

/// Computes stroke charts on one ground: by one front for open strokes with round joins, by several legs that
/// are put together for closed strokes and other joins. One thread at a time.
class GroundChartBuilder {
 public:
  /// The ground's surface must outlive the object.
  explicit GroundChartBuilder(const ChartGround& ground)
      : ground_(ground), front_(ground), legs_(ground), live_(ground.vertex_count()) {}

  /// Starts a stroke. The radius must be finite and above 0. `follow` is ignored: the ground already reflects
  /// it.
  void begin(const ChartOptions& options);

  /// Extends the chart to this curve; the result equals that of a fresh start bit for bit. The first
  /// `unchanged` points are those of the curve before. `parts` is the number of parts of a fresh front.
  Chart update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts);

  /// Does what update() does, but the result is kept from event to event, and an event costs only what it
  /// changes.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged);

  const LiveChart& live() const { return live_; }

  /// The stroke of the last chart, or null when that chart was put together from legs.
  const FrontStroke* stroke() const { return in_legs_ ? nullptr : &front_.stroke(); }
  std::uint64_t settled() const { return in_legs_ ? legs_.settled() : front_.settled(); }
  std::uint64_t pushes() const { return in_legs_ ? legs_.pushes() : front_.pushes(); }

 private:
  bool in_one_piece(const SurfaceCurve& curve);
  Chart plain(const SurfaceCurve& curve);
  Chart joined(const SurfaceCurve& curve, std::size_t unchanged);

  ChartGround ground_;
  ChartOptions options_;
  Front front_;
  JoinedLegs legs_;
  LiveChart live_;
  bool in_legs_ = false;  ///< the last chart was put together from legs
};

/// The number of parts into which the front of this curve is cut: 1 for small charts, at most one per thread.
std::size_t parts_for(const SurfaceCurve& curve, double radius);

}  // namespace burin
