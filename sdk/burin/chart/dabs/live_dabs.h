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

/// A stroke as a row of dabs (the paper's Figure 2a): normal coordinates around places along its curve, each
/// dab a sheet of its own. The surface and picker must outlive it. One thread at a time.
class LiveDabs {
 public:
  LiveDabs(const Surface& surface, const Picker& picker);

  /// Begins a stroke without dabs. `radius`: of dabs where the curve's width is 1, `spacing`: of their
  /// middles along the curve; object units, > 0. `base`: of the surface, as brushes of the radius feel it:
  /// dabs are charted on it and carried to the vertices, and the curve must run on it. Null: on the surface
  /// itself.
  void begin(double radius, double spacing, BaseSurface* base = nullptr);

  /// Puts dabs at 0, spacing, 2 spacing, ... along the curve; a closed one has a whole number of them, as
  /// near to the spacing as that goes. The first `unchanged` points are known to be those of the curve
  /// before; dabs between them stay. The same as all at once.
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged = 0);

  /// Of its nodes t is that of their dab's middle on the curve and d the second normal coordinate.
  const LiveChart& live() const { return live_; }

  /// The first normal coordinate, along the stroke: [slot].
  std::span<const float> along() const { return along_; }

  /// Nodes that the last draw() computed.
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
  std::optional<DabChartBuilder> of_base_;  ///< made for each stroke: levels differ in the number of nodes
  double radius_ = 0, spacing_ = 0;
  LiveChart live_;
  std::vector<float> along_;
  std::vector<Dab> dabs_;  ///< by rising t
  std::vector<Index> vacant_;
  std::uint64_t settled_ = 0;
  bool closed_ = false;
};

}  // namespace burin
