#pragma once
#include <burin/deform/paint.h>

#include "render.h"

namespace burin {

/// Clay that was painted: its colours over the clay by their coverage, and protected places dark. Looks at
/// the paint, of the vertices of the surface that is drawn, while the picture is made.
Albedo painted(const Paint& paint);

}  // namespace burin
