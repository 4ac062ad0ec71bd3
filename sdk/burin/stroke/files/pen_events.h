#pragma once
#include <burin/stroke/recording.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// An event of a recorder, in the recorder's units.
struct PenEvent {
  Sample sample;
  bool contact = false;  ///< the pen touches the tablet
  bool eraser = false;   ///< with its eraser
  double pointer = 0;    ///< id of the pointer, for recorders that have several
};

/// Sets contact, eraser and the button at the pen's side by the `buttons` of an HTML PointerEvent.
void set_buttons(PenEvent& event, double buttons);

/// The events of a recording.
struct PenEvents {
  std::vector<PenEvent> events;
  PenFields fields;
};

/// The event of a line of libmypaint's recordings, `time x y pressure`; pressure 0 means a lifted pen. Throws
/// Error for malformed lines, values that are not finite and pressure outside 0..1.
PenEvent mypaint_event(std::string_view line);

/// HTML PointerEvent recordings: a JSON object of arrays x, y, time (ms), or what events have instead of
/// these (clientX, timeStamp), and optionally pressure, buttons, tiltX, tiltY, twist (degrees), pointerId.
/// buttons 0 means a lifted pen, whatever its pressure; without buttons, pressure 0 does. Throws FileError
/// that names the element, `path` is for messages.
PenEvents pointer_events(const std::string& text, const std::filesystem::path& path);

/// Such arrays by their names, x, y and time.
using PointerColumns = std::map<std::string, std::vector<double>, std::less<>>;

/// The names of the arrays that are read.
std::span<const std::string_view> pointer_column_names();

/// Gives columns that were parsed by such names those of PointerColumns. Where several have one meaning, the
/// first of pointer_column_names() counts.
void use_first_names(PointerColumns& columns);

/// The same of arrays that were parsed one by one; nothing if pointer_events() would throw.
std::optional<PenEvents> pointer_events(const PointerColumns& columns);

/// The number of events of an SVC file, which its first line has. Throws Error.
std::size_t svc_count(std::string_view line);

/// The units of an SVC file: mm, seconds and pressures of 0..1, or whole numbers as the tablet sent them,
/// whose times are milliseconds, and whose pressures have a range that the file does not tell.
enum class SvcUnits { converted, of_device };

/// The event of another line, `x y time pen_down azimuth altitude pressure`, in the units of BDALab's
/// handwriting-sample: x, y are in mm, y upward; the azimuth of the pen's upper end is clockwise from the
/// tablet's top and the altitude above its plane, both in tenths of a degree; pressure is 0..1. In units of a
/// device the event has no pressure. Throws Error as mypaint_event() does.
PenEvent svc_event(std::string_view line, SvcUnits units = SvcUnits::converted);

/// The same of these seven numbers.
PenEvent svc_event(std::span<const double, 7> numbers, SvcUnits units);

/// The units of a file that begins with this text: whole numbers, of which some pressure is above 1, are a
/// device's.
SvcUnits svc_units(std::string_view text);

/// What events have made.
struct ContactStroke {
  std::vector<Sample> samples;
  bool eraser = false;
  double pointer = 0;  ///< as PenEvent has it
};

/// Makes strokes of events, in the recorder's units and in the order of their starts: one of each run in
/// which a pointer touches the tablet, with its tip or with its eraser.
class ContactStrokes {
 public:
  void take(const PenEvent& event);

  std::size_t lifted() const { return lifted_; }  ///< events in which no pointer touched
  std::vector<ContactStroke> take_strokes() { return std::move(strokes_); }

 private:
  std::vector<ContactStroke> strokes_;
  std::map<double, std::size_t> open_;  ///< the stroke of each pointer that is down
  std::size_t lifted_ = 0;
};

}  // namespace burin
