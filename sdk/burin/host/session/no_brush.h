#pragma once
#include <burin/abi/brush.h>

namespace burin {

/// A brush that reads and does nothing, of strokes that lay meshes instead.
const burin_brush& no_brush();
const burin_brush_descriptor& no_brush_descriptor();

}  // namespace burin
