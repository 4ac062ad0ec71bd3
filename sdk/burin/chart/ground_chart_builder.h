#pragma once
#include <burin/chart/chart_options.h>
#include <burin/chart/front/front.h>
#include <burin/chart/joins/joined_legs.h>
#include <burin/chart/live_chart.h>

#include <cstddef>

namespace burin {

/// Stroke charts on one ground: the front for strokes that are drawn in one piece, legs put together for
/// others.
class GroundChartBuilder {
 public:
  /// The ground's surface must outlive the object.
  explicit GroundChartBuilder(const ChartGround& ground)
      : ground_(ground), front_(ground), legs_(ground), live_(ground.vertex_count()) {}

  /// Of the options, `follow` has been dealt with and the radius is a finite number above 0.
  void begin(const ChartOptions& options);

  /// The chart of the curve, bit for bit as a fresh one.
  Chart update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts);

  /// The same at the cost of what changes.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged);

  const LiveChart& live() const { return live_; }

  /// The stroke of the last chart, if that is of one piece; else null.
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

/// Parts of a front that are worth a thread of their own.
std::size_t parts_for(const SurfaceCurve& curve, double radius);

}  // namespace burin
