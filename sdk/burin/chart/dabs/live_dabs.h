#pragma once
#include <burin/chart/dabs/dab.h>
#include <burin/chart/live_chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/picker.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A stroke as a row of dabs [Schmidt 2013, figure 2a]: normal coordinates around points along its curve.
/// Each dab is a sheet of its own. The surface and picker must outlive the object. One thread at a time.
class LiveDabs {
 public:
  LiveDabs(const Surface& surface, const Picker& picker);

  /// Starts a stroke without dabs. `radius` is that of dabs where the curve's width is 1, and `spacing` the
  /// distance of their middles along the curve; object units, > 0. With a `base`, which must outlive the
  /// stroke, the curve lies on that base surface, and dabs are computed there and interpolated to the
  /// vertices. Null means the surface itself.
  void begin(double radius, double spacing, BaseSurface* base = nullptr);

  /// Puts dabs at 0, spacing, 2 spacing, ... along the curve. On a closed curve the spacing is adjusted so
  /// that a whole number of dabs fits. The first `unchanged` points are those of the previous curve, and dabs
  /// between them stay. The result equals that of drawing the whole curve at once.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged = 0);

  /// The chart. A node's t is that of its dab's middle on the curve, and d is the second normal coordinate.
  const LiveChart& live() const { return live_; }

  /// The first normal coordinate, along the stroke, by slot of live(); object units.
  std::span<const float> along() const { return along_; }

  /// The number of nodes that the last draw() computed.
  std::uint64_t settled() const { return settled_; }

 private:
  struct Dab {
    double t;
    std::vector<Index> slots;
  };
  void take_back_from(double t);
  void put(const CurvePoint& middle);
  DabChart chart(const CurvePoint& middle);
  Index vacant_slot();

  const Surface* surface_;
  const Picker* picker_;
  DabChartBuilder builder_;
  BaseSurface* base_ = nullptr;
  std::optional<DabChartBuilder>
      of_base_;  ///< created for each stroke, since levels differ in their node counts
  double radius_ = 0, spacing_ = 0;
  LiveChart live_;
  std::vector<float> along_;
  std::vector<Dab> dabs_;  ///< by rising t
  std::vector<Index> vacant_;
  std::uint64_t settled_ = 0;
  bool closed_ = false;
};

}  // namespace burin
