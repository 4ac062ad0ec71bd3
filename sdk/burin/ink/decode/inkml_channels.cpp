// Makes samples of the values of InkML traces, in the units that their channels tell.
//
// Office programs write X and Y in HIMETRIC (0.01 mm), whatever their files say of the resolution. Elsewhere
// the units of the channel hold, divided by its resolution if it has one.
#include <burin/base/error.h>
#include <burin/ink/decode/inkml_channels.h>
#include <burin/math/degree.h>
#include <burin/math/elementary.h>
#include <burin/stroke/pen_angles.h>

#include <algorithm>
#include <array>
#include <span>

namespace burin {
namespace {

struct NamedScale {
  std::string_view unit;
  double scale;
};

double scale_of(std::string_view unit, std::span<const NamedScale> scales, double otherwise) {
  const auto found = std::ranges::find(scales, unit, &NamedScale::unit);
  return found == scales.end() ? otherwise : found->scale;
}

/// Millimetres a unit of length has, or 0 for others.
double millimetres(std::string_view unit) {
  static constexpr std::array scales = {NamedScale{"mm", 1},         NamedScale{"cm", 10},
                                        NamedScale{"m", 1000},       NamedScale{"in", 25.4},
                                        NamedScale{"pt", 25.4 / 72}, NamedScale{"pc", 25.4 / 6},
                                        NamedScale{"himetric", 0.01}};
  return scale_of(unit, scales, 0);
}

/// Seconds a unit of time has, or 0 for others.
double seconds(std::string_view unit) {
  static constexpr std::array scales = {NamedScale{"s", 1},       NamedScale{"sec", 1},
                                        NamedScale{"seconds", 1}, NamedScale{"ms", 1e-3},
                                        NamedScale{"msec", 1e-3}, NamedScale{"milliseconds", 1e-3},
                                        NamedScale{"us", 1e-6},   NamedScale{"microseconds", 1e-6},
                                        NamedScale{"ns", 1e-9}};
  return scale_of(unit, scales, 0);
}

/// What a resolution counts its values per: "s" of "1/s"; empty without a resolution.
std::string_view unit_of_resolution(const InkmlChannel& channel) {
  const std::string_view units = channel.resolution_units;
  return channel.resolution > 0 && units.starts_with("1/") ? units.substr(2) : std::string_view();
}

/// The seconds per value of a time channel: milliseconds if the file does not tell.
double time_scale(const InkmlChannel& channel) {
  constexpr double millisecond = 1e-3;
  if (const double unit = seconds(unit_of_resolution(channel)); unit > 0) return unit / channel.resolution;
  const double unit = seconds(channel.units);
  return unit > 0 ? unit : millisecond;
}

/// The millimetres per unit of a position channel.
double position_scale(const InkmlChannel& channel, bool office) {
  if (office) return millimetres("himetric");
  const std::string_view per = unit_of_resolution(channel);
  return per.empty() ? millimetres(channel.units) : millimetres(per) / channel.resolution;
}

}  // namespace

InkmlChannels::InkmlChannels(const InkmlFormat& format, bool office, bool in_space)
    : format_(format),
      x_(find("X")),
      y_(find("Y")),
      z_(in_space ? find("Z") : At()),
      time_(find("T")),
      force_(find("F")),
      tilt_x_(find("OTx")),
      tilt_y_(find("OTy")),
      azimuth_(find("OA")),
      elevation_(find("OE")),
      rotation_(find("OR")),
      tip_(find("S")),
      barrel_(find("B1")) {
  if (!has_position()) return;
  scale_ = {position_scale(channel(x_), office), position_scale(channel(y_), office), 0};
  if (z_) scale_.z() = position_scale(channel(z_), office);
  if (!(scale_.x() > 0 && scale_.y() > 0)) scale_.setZero();
  // Without a greatest force, values are no shares of it.
  if (force_ && !channel(force_).most) force_.reset();
  if (tip_ && !channel(tip_).boolean) tip_.reset();
  if (barrel_ && !channel(barrel_).boolean) barrel_.reset();
}

InkmlChannels::At InkmlChannels::find(std::string_view name) const {
  const auto found = std::ranges::find(format_.channels, name, &InkmlChannel::name);
  return found == format_.channels.end() ? At() : At(found - format_.channels.begin());
}

PenStroke InkmlChannels::empty_stroke() const {
  PenStroke stroke;
  stroke.has_z = z_.has_value();
  stroke.fields = {.time = time_.has_value(),
                   .pressure = force_.has_value(),
                   .tilt = (tilt_x_ && tilt_y_) || (azimuth_ && elevation_),
                   .twist = rotation_.has_value(),
                   .barrel = barrel_.has_value()};
  return stroke;
}

void InkmlChannels::hold(InkmlValues& values, InkmlValues& held) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i])
      held[i] = values[i];
    else if (i != x_ && i != y_ && i != tip_ && !channel(i).otherwise)
      values[i] = held[i];
  }
}

void InkmlChannels::drop_unknown(PenStroke& stroke, const InkmlValues& held) const {
  PenFields& fields = stroke.fields;
  fields.time &= known(time_, held);
  fields.pressure &= known(force_, held);
  fields.tilt &=
      (known(tilt_x_, held) && known(tilt_y_, held)) || (known(azimuth_, held) && known(elevation_, held));
  fields.twist &= known(rotation_, held);
  fields.barrel &= known(barrel_, held);
  for (Sample& sample : stroke.samples) {
    if (!fields.time) sample.time = 0;
    if (!fields.pressure) sample.pen.pressure = Pen{}.pressure;
    if (!fields.tilt) sample.pen.tilt_x = sample.pen.tilt_y = 0;
    if (!fields.twist) sample.pen.twist = 0;
  }
}

/// The value of a channel in the direction that its name tells; its default, or 0, if the point lacks it.
double InkmlChannels::value(At at, const InkmlValues& values) const {
  const InkmlChannel& of = channel(at);
  const double told = values[*at].value_or(of.otherwise.value_or(0));
  return of.reversed ? -told : told;
}

/// An angle in radians. Resolutions count values per degree.
double InkmlChannels::angle(At at, const InkmlValues& values) const {
  const InkmlChannel& of = channel(at);
  const double told = value(at, values) / (of.resolution > 0 ? of.resolution : 1);
  return of.units == "rad" ? told : told * math::degree;
}

float InkmlChannels::pressure(double force) const {
  const double least = channel(force_).least.value_or(0), most = *channel(force_).most;
  return static_cast<float>(most > least ? std::clamp((force - least) / (most - least), 0., 1.) : 0);
}

/// `begin`: of the trace, seconds. Throws Error for a point without x or y.
Sample InkmlChannels::sample(const InkmlValues& values, double begin) const {
  if (!values[*x_] || !values[*y_]) throw Error("a point without X or Y");
  Sample sample;
  sample.position = {value(x_, values), value(y_, values), z_ ? value(z_, values) : 0};
  if (in_millimetres()) sample.position = sample.position.cwiseProduct(scale_);
  if (time_) sample.time = begin + value(time_, values) * time_scale(channel(time_));
  if (force_) sample.pen.pressure = pressure(value(force_, values));
  if (tilt_x_ && tilt_y_) {
    sample.pen.tilt_x = static_cast<float>(angle(tilt_x_, values));
    sample.pen.tilt_y = static_cast<float>(angle(tilt_y_, values));
  } else if (azimuth_ && elevation_) {
    const double around = angle(azimuth_, values), up = angle(elevation_, values);
    const double level = math::cos(up);
    set_upper_end(sample.pen, {level * math::cos(around), level * math::sin(around), math::sin(up)});
  }
  if (barrel_) sample.barrel = value(barrel_, values) != 0;
  if (rotation_) sample.pen.twist = static_cast<float>(angle(rotation_, values));
  return sample;
}

bool InkmlChannels::tilted(const InkmlValues& values) const {
  return std::ranges::any_of(std::array{tilt_x_, tilt_y_, azimuth_, elevation_},
                             [&](const At& at) { return at && values[*at].value_or(0) != 0; });
}

}  // namespace burin
