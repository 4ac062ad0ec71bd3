// Follows the touches of a device by their slots [kernel.org, Multi-touch Protocol, type B].
#include <burin/ink/decode/evdev_touches.h>

#include <algorithm>

namespace burin {
namespace {

// Names and numbers are those of linux/input-event-codes.h.
constexpr unsigned abs_mt_slot = 0x2f, abs_mt_last = 0x3d, abs_mt_position_x = 0x35, abs_mt_position_y = 0x36,
                   abs_mt_tracking_id = 0x39, abs_mt_pressure = 0x3a;

}  // namespace

bool EvdevTouches::is_of_touches(unsigned code) { return code >= abs_mt_slot && code <= abs_mt_last; }

void EvdevTouches::take(unsigned code, int value) {
  if (code == abs_mt_slot) {
    slot_ = value;
    return;
  }
  Slot& slot = slots_[slot_];
  if (code != abs_mt_tracking_id) {
    slot.values[code] = value;
    return;
  }
  slot.down = value >= 0;
  slot.stroke.reset();
}

bool EvdevTouches::end_frame(double time, PenFile& content) {
  bool touches = false;
  for (auto& [number, slot] : slots_) {
    if (!slot.down || !slot.values.contains(abs_mt_position_x) || !slot.values.contains(abs_mt_position_y))
      continue;
    touches = true;
    add_sample(slot, time, content);
  }
  return touches;
}

void EvdevTouches::add_sample(Slot& slot, double time, PenFile& content) {
  const EvdevAxis* pressure = axis_of(axes_, abs_mt_pressure);
  if (!slot.stroke) {
    slot.stroke = content.strokes.size();
    PenStroke& made = content.strokes.emplace_back();
    made.tool = "touch";
    made.fields.time = true;
    made.fields.pressure = pressure && slot.values.contains(abs_mt_pressure);
  }
  PenStroke& stroke = content.strokes[*slot.stroke];
  Sample& sample = stroke.samples.emplace_back();
  sample.time = time;
  const EvdevPlane plane(axes_, abs_mt_position_x, abs_mt_position_y);
  sample.position = plane.position(slot.values[abs_mt_position_x], slot.values[abs_mt_position_y]);
  if (plane.has_millimetres()) content.unit = "mm";
  if (stroke.fields.pressure)
    sample.pen.pressure = static_cast<float>(share_of(*pressure, slot.values[abs_mt_pressure]));
}

void EvdevTouches::part_strokes() {
  for (auto& [number, slot] : slots_) slot.stroke.reset();
}

}  // namespace burin
