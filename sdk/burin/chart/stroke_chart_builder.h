#pragma once
#include <burin/chart/chart.h>
#include <burin/chart/chart_options.h>
#include <burin/chart/live_chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace burin {

/// Computes stroke charts on one surface [Schmidt 2013, section 4]. Holds scratch memory of five bytes a
/// vertex, so keep one as long as the surface; a chart costs in proportion to its own region only.
/// Surface and levels must outlive it. One thread at a time.
class StrokeChartBuilder {
 public:
  /// `levels`: of the surface, for strokes that do not follow all of its relief; null: all do.
  explicit StrokeChartBuilder(const Surface& surface, const SurfaceLevels* levels = nullptr);
  ~StrokeChartBuilder();
  StrokeChartBuilder(StrokeChartBuilder&&) noexcept;
  StrokeChartBuilder& operator=(StrokeChartBuilder&&) noexcept;

  /// The chart of a curve of at least one point. The result is a function of surface, curve and options.
  /// Throws ContractError for a radius that is not finite and positive or a curve without points.
  Chart chart(const SurfaceCurve& curve, const ChartOptions& options);

  /// The chart of a curve with the options of the last chart() or begin(), bit for bit what chart() would
  /// give. The front is propagated only where something differs. The first `unchanged` points are known to be
  /// those of the curve before. Closed strokes, and smooth, miter and overlap joins, start afresh. The
  /// surface must be as it was before. Throws ContractError for a curve without points or when nothing was
  /// begun.
  Chart extend(const SurfaceCurve& curve, std::size_t unchanged = 0);

  /// Begins a stroke that grows by draw(). Throws ContractError as chart().
  void begin(const ChartOptions& options);

  /// The base surface that the stroke which was begun last runs on; its curves must be curves of it. Null:
  /// the surface itself.
  BaseSurface* base();

  /// The base surface for something else of this radius and `follow` than a stroke; null: the surface itself.
  /// Any stroke is over with it.
  BaseSurface* base_for(double radius, double follow);

  /// Follows the surface after these vertices moved between strokes, by at most `distance`, object units.
  void moved(std::span<const Index> vertices, double distance);

  /// As extend(), at the cost of what changes only. Valid until the next call of any function.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged = 0);
  const LiveChart& live() const;

  /// Nodes whose coordinates the last call computed, and entries that went through the front's queue.
  std::uint64_t settled() const;
  std::uint64_t pushes() const;

 private:
  struct Stroke;
  std::unique_ptr<Stroke> stroke_;
};

}  // namespace burin
