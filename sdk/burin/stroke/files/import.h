#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <filesystem>

namespace burin {

/// Counts of what an import changed or left out.
struct ImportCounts {
  std::size_t events = 0;        ///< events in the file
  std::size_t lifted = 0;        ///< events left out since the pen did not touch the tablet
  std::size_t times_raised = 0;  ///< samples whose time was raised since it fell within a stroke
  /// Strokes that lost their pressure since the file has pressure 0 in contact everywhere.
  std::size_t pressures_dropped = 0;
};

/// An imported recording.
struct Import {
  Recording recording;
  ImportCounts counts;
};

// The functions below import recordings of other programs as screen-space strokes for a camera. They map the
// recorder's pixels onto the camera's viewport: scaled uniformly so that the bounding box of all strokes fits
// into the viewport less a margin of 10 % on each side, and centred. Events with the pen lifted end a stroke;
// a tap is a stroke of one position. Brush and radius stay unset. Times are the recorder's, in seconds; a
// time that falls within a stroke is raised to the time before it. They throw FileError that names the line
// or element for malformed input, values that are not finite, pressure outside 0..1 and a file without
// strokes, and ContractError for a camera with an empty viewport or without an inverse.

/// Imports libmypaint's event recordings: lines of `time x y pressure`; pressure 0 means a lifted pen.
Import import_mypaint_events(const std::filesystem::path& path, const Camera& camera);

/// Imports HTML PointerEvent recordings: a JSON object of arrays x, y, time (ms) and optionally pressure,
/// buttons, tiltX, tiltY, twist (degrees), pointerId. buttons 0 means a lifted pen, whatever its pressure;
/// without buttons, pressure 0 does. Each pointer has strokes of its own; strokes are in the order of their
/// starts.
Import import_pointer_events(const std::filesystem::path& path, const Camera& camera);

/// Imports SVC files in the units of BDALab's handwriting-sample: the number of events, then lines of `x y
/// time pen_down azimuth altitude pressure`. x, y are in mm, y upward; the azimuth of the pen's upper end is
/// clockwise from the tablet's top and the altitude above its plane, both in tenths of a degree; pressure is
/// 0..1.
Import import_svc(const std::filesystem::path& path, const Camera& camera);

}  // namespace burin
