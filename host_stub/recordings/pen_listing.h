#pragma once
#include <burin/ink/pen_file.h>

#include <string>

#include "system/console.h"

namespace burin::command {

/// The pages of a pen file, their layers and the strokes of these, a line each:
///   page 1
///     layer 1
///       stroke 1: 23 samples, pen, 0.53 s, pressure, tilt
/// Strokes are counted through the whole file, in its order.
std::string listing_text(const PenFile& file);

/// A list with an object per stroke, of its stroke, page, layer, samples, tool, eraser, seconds, fields.
Json listing_json(const PenFile& file);

}  // namespace burin::command
