#pragma once
#include <burin/stroke/recording.h>

#include <filesystem>

namespace burin {

// Recordings of other programs as screen-space strokes for a camera. The recorder's pixels are mapped onto
// the camera's viewport: uniformly scaled so that the box of all strokes fits into the viewport less a
// margin of 10 % on each side, and centred. Events with the pen lifted end a stroke. Strokes of fewer than
// two distinct places are left out; settings (brush, radius) stay open. Times are the recorder's, in
// seconds; one that falls within a stroke is raised to the time before it. Throws FileError that names the
// line or element: malformed input, values that are not finite, pressure outside 0..1, and a file without
// strokes. Throws ContractError for a camera without a viewport or inverse.

/// libmypaint's event recordings: lines of `time x y pressure`; pressure 0 lifts the pen.
Recording import_mypaint_events(const std::filesystem::path& path, const Camera& camera);

/// HTML PointerEvent recordings: a JSON object of arrays x, y, time (ms) and, where present, pressure
/// (0 lifts the pen), buttons (0 lifts the pen), tiltX, tiltY, twist (degrees).
Recording import_pointer_events(const std::filesystem::path& path, const Camera& camera);

/// SVC files in the units of BDALab's handwriting-sample: the number of events, then lines of `x y time
/// pen_down azimuth altitude pressure`: x, y in mm, y upward; azimuth of the pen's upper end clockwise from
/// the tablet's top and altitude above its plane in tenths of a degree; pressure 0..1.
Recording import_svc(const std::filesystem::path& path, const Camera& camera);

}  // namespace burin
