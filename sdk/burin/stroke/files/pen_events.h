#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// An event of a recorder, in the recorder's units.
struct PenEvent {
  Sample sample;
  bool contact = false;  ///< the pen touches the tablet
  double pointer = 0;    ///< id of the pointer, for recorders that have several
};

/// The events of a recording.
struct PenEvents {
  std::vector<PenEvent> events;
  PenFields fields;
};

// The functions below read the events in the text of a recording of another program; `path` is for messages.
// They throw FileError that names the line or element for malformed input, values that are not finite and
// pressure outside 0..1.

/// libmypaint's event recordings: lines of `time x y pressure`; pressure 0 means a lifted pen.
PenEvents mypaint_events(const std::string& text, const std::filesystem::path& path);

/// HTML PointerEvent recordings: a JSON object of arrays x, y, time (ms) and optionally pressure, buttons,
/// tiltX, tiltY, twist (degrees), pointerId. buttons 0 means a lifted pen, whatever its pressure; without
/// buttons, pressure 0 does.
PenEvents pointer_events(const std::string& text, const std::filesystem::path& path);

/// Such arrays by their names.
using PointerColumns = std::map<std::string, std::vector<double>, std::less<>>;

/// The names of the arrays that are read.
std::span<const std::string_view> pointer_column_names();

/// The same of arrays that were parsed one by one; nothing if pointer_events() would throw.
std::optional<PenEvents> pointer_events(const PointerColumns& columns);

/// SVC files in the units of BDALab's handwriting-sample: the number of events, then lines of `x y time
/// pen_down azimuth altitude pressure`. x, y are in mm, y upward; the azimuth of the pen's upper end is
/// clockwise from the tablet's top and the altitude above its plane, both in tenths of a degree; pressure is
/// 0..1.
PenEvents svc_events(const std::string& text, const std::filesystem::path& path);

/// The strokes of events, in the recorder's units and in the order of their starts: one of each run in which
/// a pointer touches the tablet. `lifted` becomes the number of events in which none does.
std::vector<RecordedStroke> contact_strokes(const PenEvents& recorded, std::size_t& lifted);

}  // namespace burin
