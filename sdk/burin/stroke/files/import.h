#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <filesystem>

namespace burin {

/// What became of the events of a file besides samples of strokes.
struct ImportCounts {
  std::size_t events = 0;        ///< in the file
  std::size_t lifted = 0;        ///< of these, left out since the pen did not touch the tablet
  std::size_t times_raised = 0;  ///< in strokes, since they fell
  /// Strokes without pressure, since that of the file is 0 in contact, too.
  std::size_t pressures_dropped = 0;
};

struct Import {
  Recording recording;
  ImportCounts counts;
};

// Recordings of other programs as screen-space strokes for a camera. The recorder's pixels are mapped onto
// the camera's viewport: uniformly scaled so that the box of all strokes fits into the viewport less a
// margin of 10 % on each side, and centred. Events with the pen lifted end a stroke; a tap is a stroke of one
// place. Settings (brush, radius) stay open. Times are the recorder's, in seconds; one that falls within a
// stroke is raised to the time before it. Throws FileError that names the line or element: malformed input,
// values that are not finite, pressure outside 0..1, and a file without strokes. Throws ContractError for a
// camera without a viewport or inverse.

/// libmypaint's event recordings: lines of `time x y pressure`; pressure 0 lifts the pen.
Import import_mypaint_events(const std::filesystem::path& path, const Camera& camera);

/// HTML PointerEvent recordings: a JSON object of arrays x, y, time (ms) and, where present, pressure,
/// buttons, tiltX, tiltY, twist (degrees), pointerId. No buttons lift the pen, whatever its pressure; where
/// buttons are missing, pressure 0 does. Each pointer has strokes of its own, by the time of their begin.
Import import_pointer_events(const std::filesystem::path& path, const Camera& camera);

/// SVC files in the units of BDALab's handwriting-sample: the number of events, then lines of `x y time
/// pen_down azimuth altitude pressure`: x, y in mm, y upward; azimuth of the pen's upper end clockwise from
/// the tablet's top and altitude above its plane in tenths of a degree; pressure 0..1.
Import import_svc(const std::filesystem::path& path, const Camera& camera);

}  // namespace burin
