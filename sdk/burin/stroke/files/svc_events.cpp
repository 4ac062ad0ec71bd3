// Reads recordings of handwriting in SVC files.
#include <burin/base/error.h>
#include <burin/math/elementary.h>
#include <burin/stroke/files/number_lines.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/files/recording_faults.h>
#include <burin/stroke/pen_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr double tenth_of_degree = std::numbers::pi / 1800;

/// Sets the tilt of a pen whose upper end points to `azimuth`, clockwise from the tablet's top, and
/// `altitude` above its plane, both in radians.
void set_tilt(Pen& pen, double azimuth, double altitude) {
  const double level = math::cos(altitude);
  set_upper_end(pen, {level * math::sin(azimuth), -level * math::cos(azimuth), math::sin(altitude)});
}

}  // namespace

PenEvent svc_event(std::string_view line, SvcUnits units) {
  std::array<double, 7> numbers{};
  parse_numbers(line, "seven numbers: x y time pen_down azimuth altitude pressure", numbers);
  return svc_event(numbers, units);
}

PenEvent svc_event(std::span<const double, 7> numbers, SvcUnits units) {
  const double pen_down = numbers[3], azimuth = numbers[4], altitude = numbers[5];
  if (pen_down != 0 && pen_down != 1) throw Error("pen_down must be 0 or 1");
  if (!(altitude >= 0 && altitude <= 900)) throw Error("altitude must lie in 0..900 tenths of a degree");
  PenEvent event;
  event.contact = pen_down == 1;
  event.sample.position = {numbers[0], -numbers[1], 0};
  if (units == SvcUnits::converted) {
    event.sample.time = numbers[2];
    event.sample.pen.pressure = static_cast<float>(numbers[6]);
  } else {
    event.sample.time = numbers[2] / 1000;
  }
  set_tilt(event.sample.pen, azimuth * tenth_of_degree, altitude * tenth_of_degree);
  if (const std::string_view fault = validation_error(event.sample); !fault.empty())
    throw Error(std::string(fault));
  return event;
}

SvcUnits svc_units(std::string_view text) {
  if (text.find('.') != text.npos) return SvcUnits::converted;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    const std::string_view pressure = line.substr(line.find_last_of(" \t") + 1);
    const bool whole = pressure.size() < line.size() && !pressure.empty() &&
                       pressure.find_first_not_of("0123456789") == pressure.npos;
    if (whole && pressure != "0" && pressure != "1") return SvcUnits::of_device;
  }
  return SvcUnits::converted;
}

std::size_t svc_count(std::string_view line) {
  double count = 0;
  parse_numbers(line, "one number: of the lines that follow", {&count, 1});
  constexpr double most = 1e9;
  if (!(count >= 0 && count <= most) || count != std::floor(count))
    throw Error("the number of the lines that follow must be whole");
  return static_cast<std::size_t>(count);
}

}  // namespace burin
