// Reads InkML: traces in nested groups, whose contexts tell the channels of their points.
//
// Office programs write X and Y in HIMETRIC (0.01 mm), whatever their files say of the resolution. Elsewhere
// the units of the channel hold, divided by its resolution if it has one.
#include <burin/base/error.h>
#include <burin/base/vector.h>
#include <burin/ink/decode/inkml_format.h>
#include <burin/ink/decode/inkml_trace.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/pen_file.h>
#include <burin/math/elementary.h>
#include <burin/stroke/pen_angles.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr double degree = std::numbers::pi / 180;

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

double seconds(std::string_view unit) {
  static constexpr std::array scales = {NamedScale{"s", 1}, NamedScale{"ms", 1e-3}, NamedScale{"us", 1e-6}};
  return scale_of(unit, scales, 1e-3);
}

/// Whether a program of the office wrote the file.
bool from_office(std::string_view text) {
  return text.find("schemas.microsoft.com/ink") != text.npos || text.find("fitToCurve") != text.npos ||
         text.find("id=\"inkSrc") != text.npos;
}

/// The values of a point, by channel.
using Values = std::vector<std::optional<double>>;

/// Makes samples of the values of a trace.
class InkmlChannels {
 public:
  InkmlChannels(const InkmlFormat& format, bool office);

  const InkmlFormat& format() const { return format_; }
  bool in_millimetres() const { return scale_.x() > 0; }
  bool has_elevation() const { return azimuth_ && elevation_; }
  bool has_position() const { return x_ && y_; }
  PenStroke empty_stroke() const;
  /// Whether the pen touches; unless a switch of its tip tells otherwise.
  bool touches(const Values& values) const { return !tip_ || values[*tip_].value_or(1) != 0; }
  Sample sample(const Values& values, double begin) const;
  /// Whether the values say that the pen is anything but upright, or flat along the x axis.
  bool tilted(const Values& values) const;

 private:
  using At = std::optional<std::size_t>;
  At find(std::string_view name) const;
  double value(At at, const Values& values) const;
  double angle(At at, const Values& values) const;
  float pressure(double force) const;
  const InkmlChannel& channel(At at) const { return format_.channels[*at]; }

  const InkmlFormat& format_;
  At x_, y_, z_, time_, force_, tilt_x_, tilt_y_, azimuth_, elevation_, rotation_, tip_;
  Vec3d scale_ = Vec3d::Zero();  ///< millimetres per value; 0: unknown
};

/// The millimetres per unit of a position channel.
double position_scale(const InkmlChannel& channel, bool office) {
  if (office) return millimetres("himetric");
  if (channel.resolution > 0 && channel.resolution_units.starts_with("1/"))
    return millimetres(std::string_view(channel.resolution_units).substr(2)) / channel.resolution;
  return millimetres(channel.units);
}

InkmlChannels::InkmlChannels(const InkmlFormat& format, bool office)
    : format_(format),
      x_(find("X")),
      y_(find("Y")),
      z_(find("Z")),
      time_(find("T")),
      force_(find("F")),
      tilt_x_(find("OTx")),
      tilt_y_(find("OTy")),
      azimuth_(find("OA")),
      elevation_(find("OE")),
      rotation_(find("OR")),
      tip_(find("S")) {
  if (!has_position()) return;
  scale_ = {position_scale(channel(x_), office), position_scale(channel(y_), office), 0};
  if (z_) scale_.z() = position_scale(channel(z_), office);
  if (!(scale_.x() > 0 && scale_.y() > 0)) scale_.setZero();
  // Without a greatest force, values are no shares of it.
  if (force_ && !channel(force_).most) force_.reset();
  if (tip_ && !channel(tip_).boolean) tip_.reset();
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
                   .twist = rotation_.has_value()};
  return stroke;
}

/// The value of a channel in the direction that its name tells; its default, or 0, if the point lacks it.
double InkmlChannels::value(At at, const Values& values) const {
  const InkmlChannel& of = channel(at);
  const double told = values[*at].value_or(of.otherwise.value_or(0));
  return of.reversed ? -told : told;
}

/// An angle in radians. Resolutions count values per degree.
double InkmlChannels::angle(At at, const Values& values) const {
  const InkmlChannel& of = channel(at);
  const double told = value(at, values) / (of.resolution > 0 ? of.resolution : 1);
  return of.units == "rad" ? told : told * degree;
}

float InkmlChannels::pressure(double force) const {
  const double least = channel(force_).least.value_or(0), most = *channel(force_).most;
  return static_cast<float>(most > least ? std::clamp((force - least) / (most - least), 0., 1.) : 0);
}

/// `begin`: of the trace, seconds. Throws Error for a point without x or y.
Sample InkmlChannels::sample(const Values& values, double begin) const {
  if (!values[*x_] || !values[*y_]) throw Error("a point without X or Y");
  Sample sample;
  sample.position = {value(x_, values), value(y_, values), z_ ? value(z_, values) : 0};
  if (in_millimetres()) sample.position = sample.position.cwiseProduct(scale_);
  if (time_) sample.time = begin + value(time_, values) * seconds(channel(time_).units);
  if (force_) sample.pen.pressure = pressure(value(force_, values));
  if (tilt_x_ && tilt_y_) {
    sample.pen.tilt_x = static_cast<float>(angle(tilt_x_, values));
    sample.pen.tilt_y = static_cast<float>(angle(tilt_y_, values));
  } else if (azimuth_ && elevation_) {
    const double around = angle(azimuth_, values), up = angle(elevation_, values);
    const double level = math::cos(up);
    set_upper_end(sample.pen, {level * math::cos(around), level * math::sin(around), math::sin(up)});
  }
  if (rotation_) sample.pen.twist = static_cast<float>(angle(rotation_, values));
  return sample;
}

bool InkmlChannels::tilted(const Values& values) const {
  return std::ranges::any_of(std::array{tilt_x_, tilt_y_, azimuth_, elevation_},
                             [&](const At& at) { return at && values[*at].value_or(0) != 0; });
}

/// Reads the traces of a file.
class InkmlReader {
 public:
  explicit InkmlReader(const PenFileText& file)
      : xml_(file), formats_(xml_), office_(from_office(file.text)) {}

  PenFile read() {
    collect_defined(xml_.root());
    read_group(xml_.root(), {});
    if ((office_ || elevated_) && !tilted_) drop_tilt();
    return std::move(content_);
  }

 private:
  void collect_defined(const pugi::xml_node& root);
  void read_group(const pugi::xml_node& group, std::string context);
  void read_element(const pugi::xml_node& node, const std::string& context);
  void read_defined(const pugi::xml_node& view, const std::string& context);
  void read_trace(const pugi::xml_node& trace, std::string_view context);
  void read_points(const pugi::xml_node& trace, const InkmlChannels& channels, bool lifted);
  void add_points(const pugi::xml_node& trace, PenStroke stroke);
  void drop_tilt();

  XmlFile xml_;
  InkmlFormats formats_;
  bool office_;
  bool tilted_ = false;    ///< some point has a tilt other than 0
  bool elevated_ = false;  ///< some trace has an elevation
  PenFile content_;
  std::map<std::string, pugi::xml_node> defined_;  ///< traces and groups of definitions, by "#id"
  std::map<std::string, std::size_t> stroke_of_;   ///< the stroke that a trace made last, by "#id"
};

/// Definitions hold traces that are drawn only where a view refers to them.
void InkmlReader::collect_defined(const pugi::xml_node& root) {
  for (const pugi::xml_node& node : root.children()) {
    if (local_name(node.name()) != "definitions") continue;
    for (const pugi::xml_node& one : node.children()) {
      const std::string_view name = local_name(one.name());
      if (name == "trace" || name == "traceGroup")
        defined_.emplace(std::string("#") + attribute(one, "id").value(), one);
    }
  }
}

/// Takes the traces of a group and of the groups in it. A context that stands between them holds for those
/// that follow.
void InkmlReader::read_group(const pugi::xml_node& group, std::string context) {
  if (const pugi::xml_attribute own = attribute(group, "contextRef")) context = own.value();
  for (const pugi::xml_node& node : group.children()) {
    if (local_name(node.name()) == "context") context = InkmlFormats::reference_of(node);
    read_element(node, context);
  }
}

void InkmlReader::read_element(const pugi::xml_node& node, const std::string& context) {
  const std::string_view name = local_name(node.name());
  if (name == "traceGroup") read_group(node, context);
  if (name == "trace") read_trace(node, context);
  if (name == "traceView") read_defined(node, context);
}

/// Takes what a view and the views in it refer to. What is no definition is taken where it stands.
void InkmlReader::read_defined(const pugi::xml_node& view, const std::string& context) {
  if (const auto node = defined_.extract(attribute(view, "traceDataRef").value()))
    read_element(node.mapped(), context);
  for (const pugi::xml_node& one : view.children())
    if (local_name(one.name()) == "traceView") read_defined(one, context);
}

void InkmlReader::read_trace(const pugi::xml_node& trace, std::string_view context) {
  if (const pugi::xml_attribute own = attribute(trace, "contextRef")) context = own.value();
  const InkmlChannels channels(formats_.of(trace, context), office_);
  if (!channels.has_position()) xml_.reject(trace, "a format without X or Y");
  elevated_ |= channels.has_elevation();
  try {
    read_points(trace, channels, std::string_view(attribute(trace, "type").value()) == "penUp");
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    xml_.reject(trace, error.what());
  }
  if (channels.in_millimetres() && !content_.strokes.empty()) content_.unit = "mm";
}

/// `lifted`: the pen does not touch anywhere in the trace.
void InkmlReader::read_points(const pugi::xml_node& trace, const InkmlChannels& channels, bool lifted) {
  double offset = 0;  // milliseconds
  std::string_view said = attribute(trace, "timeOffset").value();
  take_number(said, offset);
  std::string joined;
  InkmlTrace points(text_of(trace, joined), channels.format().channels.size(), channels.format().regular);
  PenStroke stroke = channels.empty_stroke();
  Values values;
  while (points.next(values)) {
    if (lifted || !channels.touches(values)) {
      ++content_.hovering;
      add_points(trace, std::exchange(stroke, channels.empty_stroke()));
      continue;
    }
    stroke.samples.push_back(channels.sample(values, offset / 1000));
    tilted_ |= channels.tilted(values);
  }
  add_points(trace, std::move(stroke));
}

/// Adds a stroke, or goes on with that of the trace before of which this one is a continuation.
void InkmlReader::add_points(const pugi::xml_node& trace, PenStroke stroke) {
  if (stroke.samples.empty()) return;
  const std::string_view part = attribute(trace, "continuation").value();
  const auto before = stroke_of_.find(attribute(trace, "priorRef").value());
  const bool goes_on = (part == "middle" || part == "end") && before != stroke_of_.end() &&
                       content_.strokes[before->second].fields == stroke.fields;
  const std::size_t at = goes_on ? before->second : content_.strokes.size();
  if (goes_on)
    std::ranges::move(stroke.samples, std::back_inserter(content_.strokes[at].samples));
  else
    content_.strokes.push_back(std::move(stroke));
  if (const pugi::xml_attribute id = attribute(trace, "id")) stroke_of_[std::string("#") + id.value()] = at;
}

/// Office programs declare the tilt of pens that have none, and write 0 for it. An elevation of 0 throughout,
/// of a pen that lies flat, is none in any file.
void InkmlReader::drop_tilt() {
  for (PenStroke& stroke : content_.strokes) {
    stroke.fields.tilt = false;
    for (Sample& sample : stroke.samples) sample.pen.tilt_x = sample.pen.tilt_y = 0;
  }
}

}  // namespace

bool is_inkml(std::string_view text) { return begins_with_element(text, "ink"); }

PenFile read_inkml(const PenFileText& file) { return InkmlReader(file).read(); }

}  // namespace burin
