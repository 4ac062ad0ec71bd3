#pragma once
#include <burin/deform/blend/vertex_sheets.h>
#include <burin/deform/overlap.h>
#include <burin/deform/paint.h>
#include <burin/surface/surface.h>

#include <limits>
#include <span>
#include <string_view>

namespace burin {

/// How sheets become one.
struct BlendOptions {
  Overlap overlap = Overlap::strongest;
  double radius = 1;                                       ///< of the stroke, object units
  double limit = std::numeric_limits<double>::infinity();  ///< vertices go no farther, object units
};

/// Where vertices go: [i] of `places` is for vertices[i], back to its base when it has no node. A vertex with
/// one node goes where displaced() puts it, bit for bit. Throws ContractError naming brush and (t, d) where
/// that is beyond the range of floats.
void blend_sheets(const Surface& surface, const StrokeSheets& stroke, std::span<const Index> vertices,
                  const BlendOptions& options, std::string_view brush, std::span<Vec3f> places);

/// The same for colours and masks: [i] of `tints` is for vertices[i], its paint's where it has no node.
void blend_tints(const Paint& paint, const StrokeSheets& stroke, std::span<const Index> vertices,
                 const BlendOptions& options, std::span<Tint> tints);

}  // namespace burin
