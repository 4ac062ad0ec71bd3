#pragma once
#include <burin/stroke/recording.h>

#include <filesystem>

namespace burin {

/// Maps a recorder's pixels onto a camera's viewport: uniformly scaled so that the recording's box fits
/// into the viewport less a margin of 10 % on each side, and centred.
/// Strokes of fewer than two places are left out; settings (brush, radius) stay open.

/// libmypaint's event recordings: lines of `time x y pressure`; pressure 0 lifts the pen.
Recording import_mypaint_events(const std::filesystem::path& path, const Camera& camera);

/// HTML PointerEvent recordings: a JSON object of arrays x, y, time (ms) and, where present, pressure,
/// tiltX, tiltY, twist (degrees), button or buttons (0 lifts the pen).
Recording import_pointer_events(const std::filesystem::path& path, const Camera& camera);

}  // namespace burin
