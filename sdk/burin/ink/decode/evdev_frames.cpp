// Makes strokes of the events of a tablet, as Linux has them.
//
// Contact is BTN_TOUCH, whatever the pressure. When the pen leaves, drivers set position, tilt and pressure
// to 0 in the frame that takes the tool away: that frame is no sample. Pucks with a lens touch all the time
// and make no strokes.
#include <burin/ink/decode/evdev_frames.h>
#include <burin/math/degree.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace burin {
namespace {

// Names and numbers are those of linux/input-event-codes.h.
constexpr unsigned ev_syn = 0, ev_key = 1, ev_abs = 3;
constexpr unsigned syn_report = 0, syn_mt_report = 2, syn_dropped = 3;
constexpr unsigned abs_x = 0x00, abs_y = 0x01, abs_z = 0x02, abs_pressure = 0x18, abs_tilt_x = 0x1a,
                   abs_tilt_y = 0x1b;
constexpr unsigned first_tool = 0x140, tool_rubber = 0x141, tool_finger = 0x145, tool_mouse = 0x146,
                   tool_lens = 0x147, touch_code = 0x14a, stylus_code = 0x14b, stylus2_code = 0x14c;

bool is_tool(const EvdevEvent& event) {
  return event.type == ev_key && event.code >= first_tool && event.code <= tool_lens;
}

}  // namespace

void EvdevFrames::take(const EvdevEvent& event) {
  if (event.type != ev_syn || event.code == syn_mt_report) {
    frame_.push_back(event);
  } else if (event.code == syn_dropped) {
    lost_ = true;
  } else if (event.code == syn_report) {
    end_frame(event.time);
  }
}

void EvdevFrames::end_frame(double time) {
  const bool leaves = pen_leaves();
  for (const EvdevEvent& event : frame_) apply(event);
  frame_.clear();
  // What the kernel threw away is unknown until the next frame, and pen and fingers may have been lifted.
  const bool lost = std::exchange(lost_, false);
  if (lost) {
    touches_.part_strokes();
    packets_.part_strokes();
  }
  const bool in_slots = touches_.end_frame(time, content_), in_packets = packets_.end_frame(time, content_);
  const bool fingers = in_slots || in_packets;
  const bool pen = !leaves && !lost && touches() && (!fingers || pen_is_near());
  if (pen)
    add_sample(time);
  else
    stroke_.reset();
  if (!pen && !fingers) ++content_.hovering;
}

bool EvdevFrames::pen_leaves() const {
  return std::ranges::any_of(frame_,
                             [](const EvdevEvent& event) { return is_tool(event) && event.value == 0; });
}

void EvdevFrames::apply(const EvdevEvent& event) {
  if (event.type == ev_syn) packets_.end_packet();
  if (event.type == ev_abs) set_axis(event.code, event.value);
  if (event.type == ev_key && event.code == touch_code) {
    touch_ = event.value != 0;
    if (!touch_) packets_.lift();
  }
  if (event.type == ev_key && (event.code == stylus_code || event.code == stylus2_code))
    stylus_[event.code - stylus_code] = event.value != 0;
  if (!is_tool(event)) return;
  sends_tools_ = true;
  if (event.value != 0)
    tool_ = event.code;
  else if (tool_ == event.code)
    tool_.reset();
}

void EvdevFrames::set_axis(unsigned code, int value) {
  if (EvdevTouches::is_of_touches(code)) {
    touches_.take(code, value);
    if (!touches_.has_slots()) packets_.take(code, value);
  } else {
    values_[code] = value;
    if (code == abs_pressure && value == 0) packets_.lift();
  }
}

/// Of devices for fingers too, which send the position of one as if it were a pen.
bool EvdevFrames::pen_is_near() const { return tool_ && *tool_ < tool_finger; }

bool EvdevFrames::touches() const {
  const bool placed = values_.contains(abs_x) && values_.contains(abs_y);
  const bool puck = tool_ == tool_mouse || tool_ == tool_lens;
  return touch_ && placed && !puck && (tool_ || !sends_tools_);
}

void EvdevFrames::add_sample(double time) {
  const bool rubber = tool_ == tool_rubber;
  if (!stroke_ || content_.strokes[*stroke_].drawn_by.eraser != rubber) {
    stroke_ = content_.strokes.size();
    content_.strokes.emplace_back().drawn_by = {tool_ == tool_finger ? "touch" : "", rubber};
  }
  PenStroke& stroke = content_.strokes[*stroke_];
  set_fields(stroke);
  Sample& sample = stroke.samples.emplace_back();
  sample.time = time;
  sample.barrel = stylus_[0].value_or(false) || stylus_[1].value_or(false);
  sample.position = EvdevPlane(axes_, abs_x, abs_y).position(values_[abs_x], values_[abs_y]);
  set_pen(stroke.fields, values_, sample.pen);
}

void EvdevFrames::set_pen(const PenFields& fields, const EvdevValues& values, Pen& pen) const {
  const auto value = [&](unsigned code) {
    const auto sent = values.find(code);
    return sent == values.end() ? 0 : sent->second;
  };
  if (fields.pressure) pen.pressure = static_cast<float>(share_of(*axis(abs_pressure), value(abs_pressure)));
  if (fields.tilt) {
    pen.tilt_x = static_cast<float>(tilt(*axis(abs_tilt_x), value(abs_tilt_x)));
    pen.tilt_y = static_cast<float>(tilt(*axis(abs_tilt_y), value(abs_tilt_y)));
  }
  if (fields.twist) pen.twist = static_cast<float>(twist(*axis(abs_z), value(abs_z)));
}

/// What the device has sent so far; of axes without a range only the position means something. What is sent
/// for the first time within a stroke was 0 before, since only changes are sent; of no button was any held.
void EvdevFrames::set_fields(PenStroke& stroke) const {
  const auto sent = [&](unsigned code) { return values_.contains(code) && axis(code); };
  // At 0 a tilt need not be sent, unless that is the end of its range.
  const auto told = [&](unsigned code) { return sent(code) || (axis(code) && axis(code)->least < 0); };
  const PenFields before = stroke.fields;
  stroke.fields.time = true;
  stroke.fields.barrel |= stylus_[0].has_value() || stylus_[1].has_value();
  stroke.fields.pressure |= sent(abs_pressure);
  stroke.fields.tilt |= (sent(abs_tilt_x) || sent(abs_tilt_y)) && told(abs_tilt_x) && told(abs_tilt_y);
  stroke.fields.twist |= sent(abs_z);
  const PenFields now = stroke.fields;
  const PenFields further{.pressure = now.pressure && !before.pressure,
                          .tilt = now.tilt && !before.tilt,
                          .twist = now.twist && !before.twist};
  if (further != PenFields())
    for (Sample& sample : stroke.samples) set_pen(further, {}, sample.pen);
}

/// Radians. A resolution of 57 per radian means degrees, one of 5730 hundredths; without one it is degrees
/// from the middle of the range, or tenths or hundredths where no pen leans as many degrees.
double EvdevFrames::tilt(const EvdevAxis& range, double value) {
  if (range.resolution > 0) {
    const double per_degree = range.resolution * math::degree;
    const bool power_of_ten = std::abs(per_degree - 1) < 0.01 || std::abs(per_degree - 100) < 1;
    return power_of_ten ? value * math::degree / std::round(per_degree) : value / range.resolution;
  }
  constexpr double turn = 360, tenths = 10, hundredths = 100;
  const double span = range.most - range.least;
  const double a_degree = span <= turn ? 1 : span <= turn * tenths ? tenths : hundredths;
  return (value - std::ceil((range.least + range.most) / 2)) / a_degree * math::degree;
}

/// How far the pen is turned, radians from 0 to 2 pi. The range is a whole turn; at 0 of a range around it
/// the buttons point to the right, which is a quarter off, as libinput has it.
double EvdevFrames::twist(const EvdevAxis& range, double value) {
  const double turn = (value - range.least) / (range.most - range.least + 1) + 0.25;
  return 2 * std::numbers::pi * (turn - std::floor(turn));
}

/// Takes the twist for none where it never changes: drivers send it for pens that cannot measure it.
void EvdevFrames::drop_still_twist() {
  std::set<float> twists;
  for (const PenStroke& stroke : content_.strokes)
    for (const Sample& sample : stroke.samples)
      if (stroke.fields.twist && twists.size() < 2) twists.insert(sample.pen.twist);
  if (twists.size() > 1) return;
  for (PenStroke& stroke : content_.strokes) {
    stroke.fields.twist = false;
    for (Sample& sample : stroke.samples) sample.pen.twist = Pen{}.twist;
  }
}

PenFile EvdevFrames::finish() {
  drop_still_twist();
  if (EvdevPlane(axes_, abs_x, abs_y).has_millimetres()) content_.unit = "mm";
  return std::move(content_);
}

}  // namespace burin
