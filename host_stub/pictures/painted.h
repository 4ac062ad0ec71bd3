#pragma once
#include <burin/deform/paint.h>
#include <burin/surface/mesh_file.h>

#include "pictures/render.h"

namespace burin {

/// The albedo of painted clay: colours over the clay by their coverage; protected points are dark. The result
/// refers to `paint`, which belongs to the vertices of the surface that is drawn.
Albedo painted(const Paint& paint);

/// Converts the paint of the original mesh to the surface's vertex order.
Paint paint_in_surface_order(const Surface& surface, const VertexPaint& paint);

/// Converts the paint of a surface to the vertex order of the original mesh. Colours are left out if all
/// vertices are bare, masks if all are free.
VertexPaint paint_in_source_order(const Surface& surface, const Paint& paint);

}  // namespace burin
