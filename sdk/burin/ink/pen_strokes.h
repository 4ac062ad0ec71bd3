#pragma once
#include <burin/ink/pen_file.h>
#include <burin/stroke/files/import.h>

namespace burin {

/// Imports a pen file as screen-space strokes, by the rules of stroke/files/import.h: fitted into the
/// viewport, times from the first sample of the file on. Depth (z) and drawn widths are left out. Throws
/// FileError, also for a file without a stroke.
Import import_pen_file(const std::filesystem::path& path, const Camera& camera);

}  // namespace burin
