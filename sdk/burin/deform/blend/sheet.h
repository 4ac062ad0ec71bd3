#pragma once
#include <burin/chart/live_chart.h>
#include <burin/deform/evaluate/displacement.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/paint.h>

#include <cstdint>
#include <span>

namespace burin {

/// One visit of a stroke at a vertex: what the brush does there, and where in the stroke's region that is.
struct Sheet {
  Vec3f e1, normal;     ///< unit, of the node
  Vec3f displacement;   ///< in (e1, n x e1, n), object units
  Tint tint;            ///< where the brush writes colours or masks; else anything
  double inside;        ///< 1 on the stroke or in the middle of a dab, falling to 0 at the rim
  double t;             ///< along the piece, object units
  std::uint32_t piece;  ///< of the stroke, in the order in which they were drawn
  std::uint32_t image;  ///< of the stroke's symmetry

  /// In doubles, so that floats cannot tell in which order sums were taken.
  Vec3d moved() const {
    return in_space<Vec3d>(e1.cast<double>(), normal.cast<double>(), displacement.cast<double>());
  }
};

/// The nodes of one symmetry instance of a stroke, or of the piece of it that is being drawn.
struct InstanceSheets {
  const LiveChart* chart;
  const NodeOutputs* outputs;  ///< [slot]
  /// [slot] where the stroke's width varies; else empty.
  std::span<const float> half_width = {};
  std::span<const float> dab_t = {};  ///< [slot] first coordinate within the dab; empty without dabs

  /// `radius`: of the stroke, where nodes have no half width of their own.
  Sheet sheet(Index slot, double radius, std::uint32_t piece, std::uint32_t image) const;
};

}  // namespace burin
