// Reads points from the events of a parser of JSON, as they come.
#include <burin/base/text/lower_case.h>
#include <burin/ink/decode/pointer_points.h>
#include <burin/ink/decode/tilt_angles.h>
#include <burin/math/degree.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace burin {

const std::array<PointerChannel, 5> pointer_channels = {
    PointerChannel{{"t", "time", "timestamp", "timeStamp"},
                   [](Sample& s, double v) { s.time = v / 1000; },
                   &PenFields::time},
    PointerChannel{{reported_pressure, "p", "force", "f"},
                   [](Sample& s, double v) { s.pen.pressure = static_cast<float>(v); },
                   &PenFields::pressure},
    PointerChannel{{"tiltX"},
                   [](Sample& s, double v) { s.pen.tilt_x = static_cast<float>(v * math::degree); },
                   &PenFields::tilt},
    PointerChannel{{"tiltY"},
                   [](Sample& s, double v) { s.pen.tilt_y = static_cast<float>(v * math::degree); },
                   &PenFields::tilt},
    PointerChannel{{"twist"},
                   [](Sample& s, double v) { s.pen.twist = static_cast<float>(v * math::degree); },
                   &PenFields::twist}};

namespace {

constexpr std::size_t x_slot = 0, y_slot = 1, first_channel = 2, altitude_slot = 7, azimuth_slot = 8,
                      slots = 9, no_slot = slots;
constexpr std::size_t tilt_x_slot = first_channel + tilt_x_channel,
                      tilt_y_slot = first_channel + tilt_y_channel;

/// Where a member of a point goes, and which of the channel's names it has.
struct Slot {
  std::size_t slot = no_slot, rank = 0;
};

Slot slot_of(std::string_view name) {
  if (name == "x") return {x_slot, 0};
  if (name == "y") return {y_slot, 0};
  if (name == altitude_name) return {altitude_slot, 0};
  if (name == azimuth_name) return {azimuth_slot, 0};
  for (std::size_t i = 0; i < pointer_channels.size(); ++i) {
    const auto& names = pointer_channels[i].names;
    const auto found = std::ranges::find(names, name);
    if (found != names.end() && !name.empty())
      return {first_channel + i, static_cast<std::size_t>(found - names.begin())};
  }
  return {};
}

/// Follows a stroke. A function returns false to give up.
class PlainStroke : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return take_other(); }
  bool boolean(bool) override { return take_other(); }
  bool number_integer(number_integer_t value) override { return take_number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return take_number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return take_number(value); }
  bool string(string_t& value) override {
    if (depth_ == 1 && type_follows_) stroke_.drawn_by.tool = tool_of_pointer_type(value);
    if (depth_ == 1 && kind_follows_ && is_shape_of_program(value)) return false;
    return take_other();
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override;
  bool key(string_t& name) override;
  bool end_object() override;
  bool start_array(std::size_t) override;
  bool end_array() override;
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

  PenStroke finish();

 private:
  bool take_number(double value);
  void tilt_by_angles();
  /// A value that is no number may be anywhere but in the list and in a channel.
  bool take_other() const {
    return depth_ == 0 || (depth_ != list_depth_ && !(in_point_ && at_.slot != no_slot));
  }

  std::size_t depth_ = 0;
  std::size_t list_depth_ = 0;  ///< of the points; 0 outside their list
  bool in_point_ = false;
  bool list_follows_ = false, type_follows_ = false, kind_follows_ = false, has_list_ = false;
  Slot at_;                                 ///< of the value that follows
  std::array<double, slots> values_{};      ///< of the point
  std::array<std::size_t, slots> ranks_{};  ///< 1 + the rank of its name; 0: the point lacks it
  std::array<bool, slots> whole_{};         ///< all points have it
  PenStroke stroke_;
};

bool PlainStroke::start_object(std::size_t) {
  if (in_point_) return false;
  ++depth_;
  in_point_ = list_depth_ > 0 && depth_ == list_depth_ + 1;
  if (in_point_) ranks_ = {};
  return true;
}

bool PlainStroke::key(string_t& name) {
  if (in_point_) at_ = slot_of(name);
  if (depth_ != 1 || in_point_) return true;
  list_follows_ = name == "pointers" || name == "points";
  type_follows_ = name == "pointerType";
  kind_follows_ = name == "type";
  // Two lists, lists of numbers, or a group.
  return !(list_follows_ && has_list_) && name != "x" &&
         std::ranges::find(groups_of_strokes, name) == groups_of_strokes.end();
}

bool PlainStroke::end_object() {
  --depth_;
  if (!std::exchange(in_point_, false)) return true;
  if (ranks_[x_slot] == 0 || ranks_[y_slot] == 0) return false;
  tilt_by_angles();
  const bool first = stroke_.samples.empty();
  if (first) stroke_.made_pressure = ranks_[first_channel + 1] != 1;
  Sample& sample = stroke_.samples.emplace_back();
  sample.position = {values_[x_slot], values_[y_slot], 0};
  for (std::size_t slot = first_channel; slot < altitude_slot; ++slot) {
    if (ranks_[slot] > 0) pointer_channels[slot - first_channel].set(sample, values_[slot]);
    whole_[slot] = (first || whole_[slot]) && ranks_[slot] > 0;
  }
  return true;
}

/// Gives a point the tilts that it tells by other angles only.
void PlainStroke::tilt_by_angles() {
  const auto has = [&](std::size_t slot) { return ranks_[slot] > 0; };
  if (has(tilt_x_slot) || has(tilt_y_slot) || !has(altitude_slot) || !has(azimuth_slot)) return;
  const auto [x, y] = tilts_of(values_[altitude_slot], values_[azimuth_slot]);
  values_[tilt_x_slot] = x;
  values_[tilt_y_slot] = y;
  ranks_[tilt_x_slot] = ranks_[tilt_y_slot] = 1;
}

bool PlainStroke::start_array(std::size_t) {
  if (in_point_ || (list_depth_ > 0 && depth_ >= list_depth_)) return false;
  ++depth_;
  if (depth_ != 1 && !(depth_ == 2 && list_follows_)) return true;
  list_depth_ = depth_;
  has_list_ = true;
  return true;
}

bool PlainStroke::end_array() {
  if (depth_-- == list_depth_) list_depth_ = 0;
  return true;
}

bool PlainStroke::take_number(double value) {
  if (!in_point_ || at_.slot == no_slot) return take_other();
  if (ranks_[at_.slot] > 0 && ranks_[at_.slot] <= at_.rank) return true;
  ranks_[at_.slot] = at_.rank + 1;
  values_[at_.slot] = value;
  return true;
}

PenStroke PlainStroke::finish() {
  std::array<bool, pointer_channels.size()> whole{};
  std::copy_n(whole_.begin() + first_channel, whole.size(), whole.begin());
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i]) stroke_.fields.*pointer_channels[i].field = true;
  keep_channels(stroke_, whole);
  stroke_.made_pressure &= stroke_.fields.pressure;
  return std::move(stroke_);
}

}  // namespace

std::optional<JsonValue> told(const JsonValue& value, std::string_view name) {
  auto found = value.find(std::string(name));
  return found && !found->is_null() ? found : std::nullopt;
}

std::optional<JsonValue> channel_of(const JsonValue& value, const PointerChannel& channel) {
  for (const std::string_view name : channel.names)
    if (!name.empty())
      if (auto found = told(value, name)) return found;
  return std::nullopt;
}

std::array<double, 2> tilts_of(double altitude, double azimuth) {
  Pen pen;
  set_tilt(pen, azimuth, altitude);
  return {pen.tilt_x / math::degree, pen.tilt_y / math::degree};
}

void keep_channels(PenStroke& stroke, const std::array<bool, pointer_channels.size()>& whole) {
  const Sample neutral;
  for (Sample& sample : stroke.samples) {
    if (!whole[0]) sample.time = neutral.time;
    if (!whole[1]) sample.pen.pressure = neutral.pen.pressure;
    if (!whole[2]) sample.pen.tilt_x = neutral.pen.tilt_x;
    if (!whole[3]) sample.pen.tilt_y = neutral.pen.tilt_y;
    if (!whole[4]) sample.pen.twist = neutral.pen.twist;
  }
}

std::string_view tool_of_pointer_type(std::string_view type) {
  static constexpr std::array<std::string_view, 3> tools = {"pen", "touch", "mouse"};
  const auto found = std::ranges::find(tools, in_lower_case(std::string(type)));
  return found == tools.end() ? std::string_view() : *found;
}

bool is_shape_of_program(std::string_view type) {
  static constexpr std::array<std::string_view, 4> shapes = {"decorator", "edge", "shape", "text"};
  return std::ranges::find(shapes, type) != shapes.end();
}

std::optional<PenStroke> plain_pointer_stroke(std::string_view json) {
  PlainStroke stroke;
  if (!nlohmann::json::sax_parse(json, &stroke)) return std::nullopt;
  return stroke.finish();
}

}  // namespace burin
