// Makes strokes of the sensor data in the Universal Ink Model, whose numbers are differences in steps that
// the channel's description tells.
#include <burin/base/error.h>
#include <burin/ink/decode/tilt_angles.h>
#include <burin/ink/decode/uim_sensors.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr double pixels_a_metre = 96 / 0.0254;

/// The values of a channel, in its unit and in the unit that its resolution makes of it.
struct Values {
  std::vector<double> values;
  double resolution = 0, most = 0;
};

constexpr std::int64_t most_precision = 15;

Values values_of(const UimChannel& channel, const std::vector<std::int64_t>& numbers) {
  if (channel.precision < 0 || channel.precision > most_precision)
    throw Error("the precision of a channel must lie in 0..15");
  double steps = 1;
  for (std::int64_t i = 0; i < channel.precision; ++i) steps *= 10;
  Values made{{}, channel.resolution, channel.most};
  std::uint64_t sum = 0;  // unsigned, since damaged files overflow
  for (const std::int64_t number : numbers) {
    sum += static_cast<std::uint64_t>(number);
    made.values.push_back(static_cast<double>(static_cast<std::int64_t>(sum)) / steps);
  }
  return made;
}

/// The channels of one group by the last word of their type.
class Measured {
 public:
  Measured(const UimSensorData& data, const UimChannels& channels) {
    const UimChannel* x = nullptr;
    for (const auto& [id, numbers] : data.numbers)
      if (const auto found = channels.find(id); found != channels.end() && name_of(found->second) == "X")
        x = &found->second;
    if (!x) return;
    tool_ = x->tool;
    for (const auto& [id, numbers] : data.numbers)
      if (const auto found = channels.find(id); found != channels.end() && found->second.group == x->group)
        values_.emplace(name_of(found->second), values_of(found->second, numbers));
  }

  bool has_positions() const { return values_.contains("X"); }

  /// The values of a channel of which there are as many as positions, or null.
  const Values* find(const std::string& name) const {
    const auto found = values_.find(name);
    return found != values_.end() && found->second.values.size() == size() ? &found->second : nullptr;
  }
  std::size_t size() const { return values_.at("X").values.size(); }
  std::string_view tool() const { return tool_; }

 private:
  static std::string name_of(const UimChannel& channel) {
    return channel.type.substr(channel.type.find_last_of('/') + 1);
  }

  std::map<std::string, Values> values_;
  std::string_view tool_;
};

void set_positions(const Values& x, const Values& y, PenStroke& stroke) {
  const auto scale = [](double resolution) { return resolution > 0 ? pixels_a_metre / resolution : 1; };
  const double by_x = scale(x.resolution), by_y = scale(y.resolution);
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].position = {x.values[i] * by_x, y.values[i] * by_y, 0};
}

void set_times(const Values& times, double start, PenStroke& stroke) {
  constexpr double usual = 1000;
  const double per_second = times.resolution > 0 ? times.resolution : usual;
  stroke.fields.time = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].time = start + times.values[i] / per_second;
}

/// Pressures are shares of 1, or of the greatest one that the device tells where some are above 1.
void set_pressures(const Values& pressures, PenStroke& stroke) {
  const bool shares = std::ranges::max(pressures.values) <= 1 || pressures.most <= 1;
  const double whole = shares ? 1 : pressures.most;
  stroke.fields.pressure = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].pen.pressure = static_cast<float>(pressures.values[i] / whole);
}

void set_tilts(const Values& altitudes, const Values& azimuths, PenStroke& stroke) {
  stroke.fields.tilt = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    set_tilt(stroke.samples[i].pen, azimuths.values[i], altitudes.values[i]);
}

/// How far the pen is turned, radians; 0 throughout is what pens tell that cannot measure it.
void set_twists(const Values& rotations, PenStroke& stroke) {
  if (std::ranges::all_of(rotations.values, [](double value) { return value == 0; })) return;
  stroke.fields.twist = true;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i)
    stroke.samples[i].pen.twist = static_cast<float>(rotations.values[i]);
}

}  // namespace

void add_stroke(const UimSensorData& data, const UimChannels& channels, PenFile& file) {
  const Measured measured(data, channels);
  if (!measured.has_positions()) return;
  const Values *x = measured.find("X"), *y = measured.find("Y");
  if (!y) throw Error("sensor data whose channels X and Y differ in their counts");
  if (data.hovering) {
    file.hovering += measured.size();
    return;
  }
  if (measured.size() == 0) return;
  PenStroke stroke;
  stroke.drawn_by.tool = measured.tool();
  stroke.samples.resize(measured.size());
  set_positions(*x, *y, stroke);
  if (const Values* times = measured.find("Timestamp")) set_times(*times, data.start, stroke);
  if (const Values* pressures = measured.find("Pressure")) set_pressures(*pressures, stroke);
  const Values *altitudes = measured.find("Altitude"), *azimuths = measured.find("Azimuth");
  if (altitudes && azimuths) set_tilts(*altitudes, *azimuths, stroke);
  if (const Values* rotations = measured.find("Rotation")) set_twists(*rotations, stroke);
  file.strokes.push_back(std::move(stroke));
}

}  // namespace burin
