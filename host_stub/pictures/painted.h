#pragma once
#include <burin/deform/paint.h>
#include <burin/surface/mesh_file.h>

#include "pictures/render.h"

namespace burin {

/// Clay that was painted: its colours over the clay by their coverage, and protected places dark. Looks at
/// the paint, of the vertices of the surface that is drawn, while the picture is made.
Albedo painted(const Paint& paint);

/// What is painted on the vertices of the mesh that a surface was made of, in the surface's order.
Paint paint_in_surface_order(const Surface& surface, const VertexPaint& paint);

/// What is painted on a surface, in the order of the mesh that it was made of; without the colours where all
/// are bare, without the masks where all are free.
VertexPaint paint_in_source_order(const Surface& surface, const Paint& paint);

}  // namespace burin
