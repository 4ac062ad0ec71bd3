#pragma once
#include <burin/chart/live_chart.h>
#include <burin/deform/evaluate/displacement.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/paint.h>

#include <cstdint>
#include <span>

namespace burin {

/// One visit of a stroke to a vertex: the outputs of the brush, and the position of the node within the
/// stroke.
struct Sheet {
  Vec3f e1, normal;     ///< frame of the node; unit vectors
  Vec3f displacement;   ///< in (e1, n x e1, n), object units
  Tint tint;            ///< unspecified if the brush writes neither colours nor masks
  double inside;        ///< 1 on the stroke or in the middle of a dab, falling to 0 at the rim
  double t;             ///< arc length along the piece, object units
  std::uint32_t piece;  ///< index of the piece, in the order of drawing
  std::uint32_t image;  ///< index of the symmetric image

  /// The displacement in object space, in doubles.
  Vec3d moved() const {
    return in_space<Vec3d>(e1.cast<double>(), normal.cast<double>(), displacement.cast<double>());
  }
};

/// The nodes of one symmetry instance of a stroke, or of its current piece. Non-owning.
struct InstanceSheets {
  const LiveChart* chart;
  const NodeOutputs* outputs;  ///< [slot]
  /// [slot] half width, object units; empty if the stroke's width does not vary.
  std::span<const float> half_width = {};
  std::span<const float> dab_t = {};  ///< [slot] first coordinate within the dab; empty without dabs

  /// The sheet of a slot. `radius` is the half width of nodes without one of their own, object units.
  Sheet sheet(Index slot, double radius, std::uint32_t piece, std::uint32_t image) const;
};

}  // namespace burin
