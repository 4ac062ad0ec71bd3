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

/// Computes stroke charts on one surface [Schmidt 2013, section 4]. Holds about nine bytes of scratch memory
/// per vertex, so keep one object as long as the surface. A chart of n nodes costs O(n log n), whatever the
/// size of the surface. Surface and levels must outlive the object. One thread at a time.
class StrokeChartBuilder {
 public:
  /// `levels` are those of the surface; strokes with `follow` below 1 need them. Null: all strokes follow all
  /// of the relief.
  explicit StrokeChartBuilder(const Surface& surface, const SurfaceLevels* levels = nullptr);
  ~StrokeChartBuilder();
  StrokeChartBuilder(StrokeChartBuilder&&) noexcept;
  StrokeChartBuilder& operator=(StrokeChartBuilder&&) noexcept;

  /// Computes the chart of a curve of at least one point. The result is a function of surface, curve and
  /// options. Throws ContractError for a radius that is not finite and positive, or a curve without points.
  Chart chart(const SurfaceCurve& curve, const ChartOptions& options);

  /// Computes the chart of a curve with the options of the last chart() or begin(); the result equals that of
  /// chart() bit for bit. Only what differs from the previous curve is computed, except on closed strokes and
  /// with joins that are not round. The first `unchanged` points are those of the previous curve. The surface
  /// must not have changed. Throws ContractError for a curve without points, or before any chart() or
  /// begin().
  Chart extend(const SurfaceCurve& curve, std::size_t unchanged = 0);

  /// Starts a stroke that grows by draw(). Throws ContractError for a radius that is not finite and positive.
  void begin(const ChartOptions& options);

  /// The base surface on which the current stroke runs and its curves must lie; null for the surface itself.
  BaseSurface* base();

  /// The base surface for another purpose than a stroke chart, with this radius and `follow`; null for the
  /// surface itself. `fine`: as ChartOptions::fine. Ends the current stroke.
  BaseSurface* base_for(double radius, double follow, bool fine);

  /// Updates the base surface after these vertices moved, between strokes, by at most `distance`, object
  /// units.
  void moved(std::span<const Index> vertices, double distance);

  /// Does what extend() does, at the cost of what changes only. The chart is valid until the next call of any
  /// function.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged = 0);
  const LiveChart& live() const;

  /// The number of nodes whose coordinates the last call computed, and of entries pushed to the front's
  /// queue.
  std::uint64_t settled() const;
  std::uint64_t pushes() const;

 private:
  struct Stroke;
  std::unique_ptr<Stroke> stroke_;
};

}  // namespace burin
