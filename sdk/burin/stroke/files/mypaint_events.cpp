// Reads libmypaint's event recordings.
#include <burin/base/error.h>
#include <burin/stroke/files/number_lines.h>
#include <burin/stroke/files/pen_events.h>
#include <burin/stroke/files/recording_faults.h>

#include <array>

namespace burin {
PenEvent mypaint_event(std::string_view line) {
  std::array<double, 4> numbers{};
  parse_numbers(line, "four numbers: time x y pressure", numbers);
  PenEvent event;
  event.sample.time = numbers[0];
  event.sample.position = {numbers[1], numbers[2], 0};
  event.sample.pen.pressure = static_cast<float>(numbers[3]);
  event.contact = numbers[3] > 0;
  if (const std::string_view fault = validation_error(event.sample); !fault.empty())
    throw Error(std::string(fault));
  return event;
}

}  // namespace burin
