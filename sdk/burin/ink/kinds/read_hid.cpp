// Reads recordings of hid-recorder: "R: n bytes" is the device's report descriptor, by which the reports
// "E: time n bytes" are cut into fields.
//
// Contact is the tip switch or the eraser switch; some pens set the tip's for an eraser, and say that they
// are inverted. Reports that lack the position belong to something else: the battery, or the tablet's
// buttons. Reports of touches with ids are read by decode/hid_touches.h.
#include <burin/base/error.h>
#include <burin/ink/decode/hid_touches.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/hid_descriptor.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/text_window.h>
#include <burin/ink/pen_file.h>
#include <burin/math/degree.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t usage_tilt_y = 0x0d003e, usage_twist = 0x0d0041, usage_barrel2 = 0x0d005a,
                        usage_invert = 0x0d003c;
constexpr std::array pen_usages{usage_x,      usage_y,       usage_tip,   usage_pressure,
                                usage_tilt_x, usage_tilt_y,  usage_twist, usage_eraser,
                                usage_barrel, usage_barrel2, usage_invert};

/// "n bytes", the bytes in hexadecimal.
Bytes parse_bytes(std::string_view rest) {
  std::size_t count = 0;
  if (!read_whole(take_word(rest), count) || count > rest.size()) throw Error("expected a count of bytes");
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes)
    if (!read_whole(take_word(rest), byte, 16)) throw Error("expected as many bytes as the line counts");
  if (!take_word(rest).empty()) throw Error("more bytes than the line counts");
  return bytes;
}

/// Reads the reports of a device.
class HidPen {
 public:
  explicit HidPen(const std::vector<HidField>& fields);

  void take(double time, const Bytes& bytes);
  PenFile finish() { return std::move(content_); }

 private:
  const HidField* find(std::uint32_t usage, const HidReport& report) const;
  std::optional<std::int32_t> value(std::uint32_t usage, const HidReport& report) const;
  double position(const HidField& field, const HidReport& report);
  float angle(std::uint32_t usage, const HidReport& report) const;
  void add_sample(double time, const HidReport& report, bool eraser);

  bool has_ids_;
  std::map<std::pair<std::uint8_t, std::uint32_t>, HidField> fields_;  ///< the first of a report and a usage
  HidTouches touches_;
  bool down_ = false;
  PenFile content_;
};

HidPen::HidPen(const std::vector<HidField>& fields) : has_ids_(have_report_ids(fields)), touches_(fields) {
  for (const HidField& field : fields)
    if (std::ranges::find(pen_usages, field.usage) != pen_usages.end())
      fields_.try_emplace({field.report, field.usage}, field);
}

/// The field of this usage in the report.
const HidField* HidPen::find(std::uint32_t usage, const HidReport& report) const {
  const auto found = fields_.find({report.id, usage});
  return found != fields_.end() && report.has(found->second) ? &found->second : nullptr;
}

std::optional<std::int32_t> HidPen::value(std::uint32_t usage, const HidReport& report) const {
  const HidField* field = find(usage, report);
  return field ? std::optional(hid_value(*field, report)) : std::nullopt;
}

void HidPen::take(double time, const Bytes& bytes) {
  const HidReport report = hid_report(bytes, has_ids_);
  if (touches_.take(time, report, content_)) return;
  if (!find(usage_x, report) || !find(usage_y, report) || !find(usage_tip, report)) return;
  const bool tip = value(usage_tip, report).value_or(0) != 0;
  const bool inverted = value(usage_invert, report).value_or(0) != 0;
  const bool eraser = value(usage_eraser, report).value_or(0) != 0 || (tip && inverted);
  if (tip || eraser)
    add_sample(time, report, eraser);
  else
    ++content_.hovering;
  down_ = tip || eraser;
}

double HidPen::position(const HidField& field, const HidReport& report) {
  if (hid_millimetres(field) > 0) content_.unit = "mm";
  return hid_position(field, *value(field.usage, report));
}

float HidPen::angle(std::uint32_t usage, const HidReport& report) const {
  const HidField& field = *find(usage, report);
  constexpr std::uint32_t radians = 0x12;
  const double by = field.unit == radians ? 1 : math::degree;
  return static_cast<float>(hid_physical(field, *value(usage, report)) * by);
}

void HidPen::add_sample(double time, const HidReport& report, bool eraser) {
  const HidField* pressure = find(usage_pressure, report);
  const bool tilt = find(usage_tilt_x, report) && find(usage_tilt_y, report);
  if (!down_ || content_.strokes.back().drawn_by.eraser != eraser) {
    PenStroke& stroke = content_.strokes.emplace_back();
    stroke.drawn_by.eraser = eraser;
    stroke.fields = {.time = true,
                     .pressure = pressure && pressure->most > pressure->least,
                     .tilt = tilt,
                     .twist = find(usage_twist, report) != nullptr,
                     .barrel = find(usage_barrel, report) || find(usage_barrel2, report)};
  }
  PenStroke& stroke = content_.strokes.back();
  Sample& sample = stroke.samples.emplace_back();
  sample.time = time;
  sample.barrel =
      value(usage_barrel, report).value_or(0) != 0 || value(usage_barrel2, report).value_or(0) != 0;
  sample.position = {position(*find(usage_x, report), report), position(*find(usage_y, report), report), 0};
  if (stroke.fields.pressure && pressure)
    sample.pen.pressure = hid_share(*pressure, *value(usage_pressure, report));
  if (stroke.fields.tilt && tilt) {
    sample.pen.tilt_x = angle(usage_tilt_x, report);
    sample.pen.tilt_y = angle(usage_tilt_y, report);
  }
  if (stroke.fields.twist && find(usage_twist, report)) sample.pen.twist = angle(usage_twist, report);
}

/// Takes the lines of a recording. Where it is of several devices, "D:" tells which the lines that follow are
/// of.
class HidDevices {
 public:
  void take(std::string_view line);
  PenFile finish();

 private:
  struct Device {
    std::optional<HidPen> pen;
    std::string name;
  };
  std::map<unsigned, Device> devices_;
  unsigned now_ = 0;
};

void HidDevices::take(std::string_view line) {
  const std::string_view kind = line.substr(0, 2);
  line.remove_prefix(kind.size());
  skip_blanks(line);
  line = line.substr(0, line.find_last_not_of(blanks) + 1);
  if (kind == "D:" && !read_whole(line, now_)) throw Error("expected the number of a device");
  Device& device = devices_[now_];
  if (kind == "R:" && !device.pen) device.pen.emplace(hid_fields(parse_bytes(line)));
  if (kind == "N:") device.name = line;
  if (kind != "E:") return;
  if (!device.pen) throw Error("a report before the descriptor");
  double time = 0;
  if (!take_number(line, time)) throw Error("expected a time, seconds");
  device.pen->take(time, parse_bytes(line));
}

/// The strokes of one device after the other.
PenFile HidDevices::finish() {
  PenFile content;
  for (auto& [number, device] : devices_) {
    PenFile of_device = device.pen ? device.pen->finish() : PenFile();
    if (content.strokes.empty() && (content.device.empty() || !of_device.strokes.empty()))
      content.device = device.name;
    if (!of_device.strokes.empty()) content.unit = of_device.unit;
    content.hovering += of_device.hovering;
    std::ranges::move(of_device.strokes, std::back_inserter(content.strokes));
  }
  return content;
}

}  // namespace

bool is_hid(std::string_view text) {
  return text.starts_with("R: ") || text.substr(0, 65536).find("\nR: ") != text.npos;
}

PenFile read_hid(const PenFileText& file) {
  HidDevices devices;
  for_each_line_of(file, [&](std::string_view line) { devices.take(line); });
  return devices.finish();
}

}  // namespace burin
