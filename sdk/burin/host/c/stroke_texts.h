#pragma once
#include <burin/host/brush_library.h>
#include <burin/stroke/given_settings.h>

namespace burin::c {

/// Reads settings "KEY=VALUE", ended by a null pointer; `texts` may be null. Whether the value of a parameter
/// is a text is asked of its brush. `may_refine`: whether strokes may give the surface other triangles.
/// Throws plugin::Error for what read_setting_texts() refuses.
GivenSettings read_texts(const char* const* texts, const BrushLibrary& brushes, bool may_refine);

}  // namespace burin::c
