#pragma once
#include <burin/abi/brush.h>

namespace burin_probe {

/// The optional interface of a brush with this id, or null.
const void* ability(const burin_brush_descriptor& descriptor, const char* id);

}  // namespace burin_probe
