// Follows the touches of a device by their slots [kernel.org, Multi-touch Protocol, type B].
#include <burin/ink/decode/evdev_touches.h>

#include <utility>

namespace burin {

bool is_on_surface(const EvdevValues& values) {
  const auto distance = values.find(abs_mt_distance);
  return values.contains(abs_mt_position_x) && values.contains(abs_mt_position_y) &&
         (distance == values.end() || distance->second <= 0);
}

void add_touch_sample(const EvdevAxes& axes, const EvdevValues& values, double time,
                      std::optional<std::size_t>& stroke, PenFile& content) {
  const EvdevAxis* pressure = axis_of(axes, abs_mt_pressure);
  const auto pressed = values.find(abs_mt_pressure);
  if (!stroke) {
    stroke = content.strokes.size();
    PenStroke& made = content.strokes.emplace_back();
    made.drawn_by.tool = "touch";
    made.fields.time = true;
    made.fields.pressure = pressure && pressed != values.end();
  }
  PenStroke& drawn = content.strokes[*stroke];
  Sample& sample = drawn.samples.emplace_back();
  sample.time = time;
  const EvdevPlane plane(axes, abs_mt_position_x, abs_mt_position_y);
  sample.position = plane.position(values.at(abs_mt_position_x), values.at(abs_mt_position_y));
  if (plane.has_millimetres()) content.unit = "mm";
  if (drawn.fields.pressure && pressed != values.end())
    sample.pen.pressure = static_cast<float>(share_of(*pressure, pressed->second));
}

EvdevTouches::EvdevTouches(const EvdevAxes& axes) : axes_(axes), has_slots_(axes.contains(abs_mt_slot)) {}

bool EvdevTouches::is_of_touches(unsigned code) { return code >= abs_mt_slot && code <= abs_mt_last; }

void EvdevTouches::take(unsigned code, int value) {
  if (code == abs_mt_slot) {
    has_slots_ = true;
    slot_ = static_cast<std::size_t>(value);
  } else if (has_slots_ && slot_ < slots_.size()) {
    slots_[slot_].take(code, value);
  }
}

/// Only what changes is sent, so where the id is unknown a touch tells itself by its position.
void EvdevTouches::Slot::take(unsigned code, int value) {
  changed = true;
  values[code] = value;
  if (code == abs_mt_tracking_id) {
    if (id != value) stroke.reset();
    id = value;
    contact = value >= 0 ? Contact::down : Contact::up;
  } else if (contact == Contact::unknown && (code == abs_mt_position_x || code == abs_mt_position_y)) {
    contact = Contact::down;
  }
}

bool EvdevTouches::Slot::touches() const { return contact == Contact::down && is_on_surface(values); }

bool EvdevTouches::end_frame(double time, PenFile& content) {
  bool touches = false;
  for (Slot& slot : slots_) {
    const bool changed = std::exchange(slot.changed, false);
    if (!slot.touches()) {
      slot.stroke.reset();
      continue;
    }
    touches = true;
    if (changed) add_touch_sample(axes_, slot.values, time, slot.stroke, content);
  }
  return touches;
}

void EvdevTouches::part_strokes() {
  for (Slot& slot : slots_) {
    slot.contact = Contact::unknown;
    slot.changed = false;
    slot.stroke.reset();
  }
}

}  // namespace burin
