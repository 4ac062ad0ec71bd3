#pragma once
#include <burin/ink/pen_file.h>
#include <burin/stroke/files/import.h>

#include <optional>

namespace burin {

/// Which strokes of a pen file are wanted; all if nothing is given.
struct PenChoice {
  std::optional<std::size_t> page, layer;  ///< from 1
};

/// Imports a pen file as screen-space strokes, by the rules of stroke/files/import.h: fitted into the
/// viewport, times from the first sample of the file on. Depth (z) and drawn widths are left out. Throws
/// FileError, also for a file without a stroke that is wanted.
Import import_pen_file(const PenFileText& text, const Camera& camera, const PenChoice& choice = {});

}  // namespace burin
