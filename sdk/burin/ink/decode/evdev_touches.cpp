// Follows the touches of a device by their slots [kernel.org, Multi-touch Protocol, type B].
#include <burin/ink/decode/evdev_touches.h>

#include <utility>

namespace burin {
namespace {

// Names and numbers are those of linux/input-event-codes.h.
constexpr unsigned abs_mt_slot = 0x2f, abs_mt_last = 0x3d, abs_mt_position_x = 0x35, abs_mt_position_y = 0x36,
                   abs_mt_tracking_id = 0x39, abs_mt_pressure = 0x3a, abs_mt_distance = 0x3b;

}  // namespace

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

bool EvdevTouches::Slot::touches() const {
  const auto distance = values.find(abs_mt_distance);
  return contact == Contact::down && values.contains(abs_mt_position_x) &&
         values.contains(abs_mt_position_y) && (distance == values.end() || distance->second <= 0);
}

bool EvdevTouches::end_frame(double time, PenFile& content) {
  bool touches = false;
  for (Slot& slot : slots_) {
    const bool changed = std::exchange(slot.changed, false);
    if (!slot.touches()) {
      slot.stroke.reset();
      continue;
    }
    touches = true;
    if (changed) add_sample(slot, time, content);
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
  for (Slot& slot : slots_) {
    slot.contact = Contact::unknown;
    slot.changed = false;
    slot.stroke.reset();
  }
}

}  // namespace burin
