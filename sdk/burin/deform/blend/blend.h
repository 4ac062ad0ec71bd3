#pragma once
#include <burin/deform/blend/vertex_sheets.h>
#include <burin/deform/overlap.h>
#include <burin/deform/paint.h>
#include <burin/surface/surface.h>

#include <limits>
#include <span>
#include <string_view>

namespace burin {

/// How the sheets of a vertex are combined.
struct BlendOptions {
  Overlap overlap = Overlap::strongest;
  double radius = 1;                                       ///< half width of the stroke, object units
  double limit = std::numeric_limits<double>::infinity();  ///< greatest displacement, object units
};

/// Sets positions[i] to the displaced position of vertices[i], which is its original position if it has no
/// node. A vertex with one node has the position that displaced() computes, bit for bit. Throws
/// ContractError, which gives brush and (t, d), if a position is beyond the range of floats. Uses all
/// threads.
void blend_sheets(const Surface& surface, const StrokeSheets& stroke, std::span<const Index> vertices,
                  const BlendOptions& options, std::string_view brush, std::span<Vec3f> positions);

/// Sets tints[i] to the combined colour and mask of vertices[i], which are those of `paint` if it has no
/// node. Uses all threads.
void blend_tints(const Paint& paint, const StrokeSheets& stroke, std::span<const Index> vertices,
                 const BlendOptions& options, std::span<Tint> tints);

}  // namespace burin
