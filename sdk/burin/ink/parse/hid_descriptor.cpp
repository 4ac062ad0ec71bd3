// Reads HID report descriptors: short items, of which global ones hold until they change and local ones until
// the next main item ("Device Class Definition for HID 1.11", section 6.2.2).
#include <burin/base/error.h>
#include <burin/ink/parse/hid_descriptor.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t most_report_bits = 8 * 4096, most_fields = 65'536;

/// A usage of Wacom's own pages, of pens and of touch, as the standard usage that it stands for: 0xff0d0042
/// is the digitizer's tip switch, 0xff000130 the generic desktop's X.
std::uint32_t standard_usage(std::uint32_t usage) {
  if (usage >> 16 != 0xff0d && usage >> 16 != 0xff00) return usage;
  const std::uint32_t page = (usage & 0xff00) >> 8;
  return (page == 0 ? 0x0d0000 : page << 16) | (usage & 0xff);
}

/// What the items so far say.
class Descriptor {
 public:
  void take(unsigned tag, unsigned type, std::uint32_t data, unsigned bytes);
  std::vector<HidField> fields;

 private:
  enum Type : unsigned { main = 0, global = 1, local = 2 };
  void take_global(unsigned tag, std::uint32_t data, std::int32_t number);
  void take_local(unsigned tag, std::uint32_t data, unsigned bytes);
  void take_input(std::uint32_t flags);

  struct Global {
    std::uint32_t page = 0;
    HidField field;
    std::uint32_t count = 0;
  };
  Global now_;
  std::vector<Global> pushed_;
  std::vector<std::uint32_t> usages_;
  std::uint32_t first_usage_ = 0;
  std::array<std::size_t, 256> bits_{};  ///< of the reports so far
};

void Descriptor::take(unsigned tag, unsigned type, std::uint32_t data, unsigned bytes) {
  const unsigned shift = bytes == 0 ? 0 : 32 - 8 * bytes;
  const auto number = static_cast<std::int32_t>(data << shift) >> shift;
  if (type == global) take_global(tag, data, number);
  if (type == local) take_local(tag, data, bytes);
  if (type != main) return;
  constexpr unsigned input = 8;
  if (tag == input) take_input(data);
  usages_.clear();
}

void Descriptor::take_global(unsigned tag, std::uint32_t data, std::int32_t number) {
  HidField& field = now_.field;
  constexpr int bits_of_exponent = 4;
  switch (tag) {
    case 0:
      now_.page = data;
      break;
    case 1:
      field.least = number;
      break;
    // Writers of descriptors forget that items are signed: 65535 in two bytes.
    case 2:
      field.most = field.least < 0 ? static_cast<double>(number) : data;
      break;
    case 3:
      field.physical_least = number;
      break;
    case 4:
      field.physical_most = field.physical_least < 0 ? static_cast<double>(number) : data;
      break;
    case 5:
      field.exponent = static_cast<int>(data & 15) - ((data & 8) ? 1 << bits_of_exponent : 0);
      break;
    case 6:
      field.unit = data;
      break;
    case 7:
      field.bits = data;
      break;
    case 8:
      field.report = static_cast<std::uint8_t>(data);
      break;
    case 9:
      now_.count = data;
      break;
    case 10:
      pushed_.push_back(now_);
      break;
    case 11:
      if (pushed_.empty()) throw Error("the descriptor pops what was not pushed");
      now_ = pushed_.back();
      pushed_.pop_back();
      break;
    default:
      break;
  }
}

void Descriptor::take_local(unsigned tag, std::uint32_t data, unsigned bytes) {
  const std::uint32_t usage = bytes == 4 ? data : now_.page << 16 | data;
  if (tag == 0) usages_.push_back(usage);
  if (tag == 1) first_usage_ = usage;
  constexpr std::uint32_t most_usages = 1024;
  if (tag == 2 && usage >= first_usage_ && usage - first_usage_ < most_usages)
    for (std::uint32_t one = first_usage_; one <= usage; ++one) usages_.push_back(one);
}

/// Fields beyond the usages have the last one.
void Descriptor::take_input(std::uint32_t flags) {
  std::size_t& bit = bits_[now_.field.report];
  if (now_.field.bits > most_report_bits || now_.count > most_report_bits ||
      bit + std::size_t{now_.field.bits} * now_.count > most_report_bits)
    throw Error("the descriptor's reports are longer than any report");
  const bool constant = flags & 1, variable = flags & 2;
  for (std::uint32_t i = 0; i < now_.count; ++i) {
    if (!constant && variable && !usages_.empty() && now_.field.bits >= 1 && now_.field.bits <= 32) {
      if (fields.size() == most_fields) throw Error("the descriptor has more fields than any device");
      HidField& field = fields.emplace_back(now_.field);
      field.bit = bit;
      field.usage = standard_usage(usages_[std::min<std::size_t>(i, usages_.size() - 1)]);
    }
    bit += now_.field.bits;
  }
}

}  // namespace

std::vector<HidField> hid_fields(std::span<const std::uint8_t> descriptor) {
  Descriptor parsed;
  while (!descriptor.empty()) {
    const unsigned head = descriptor.front();
    constexpr unsigned long_item = 0xfe;
    if (head == long_item) throw Error("the descriptor has long items, which no device uses");
    const unsigned code = head & 3, bytes = code == 3 ? 4 : code;
    if (descriptor.size() < 1 + bytes) throw Error("the descriptor is cut off");
    std::uint32_t data = 0;
    for (unsigned i = 0; i < bytes; ++i) data |= std::uint32_t{descriptor[1 + i]} << (8 * i);
    parsed.take(head >> 4, head >> 2 & 3, data, bytes);
    descriptor = descriptor.subspan(1 + bytes);
  }
  return std::move(parsed.fields);
}

bool have_report_ids(std::span<const HidField> fields) {
  return std::ranges::any_of(fields, [](const HidField& field) { return field.report != 0; });
}

HidReport hid_report(std::span<const std::uint8_t> bytes, bool has_id) {
  if (!has_id || bytes.empty()) return {0, bytes};
  return {bytes.front(), bytes.subspan(1)};
}

double hid_physical(const HidField& field, std::int32_t value) {
  const double span = field.physical_most - field.physical_least, logical = field.most - field.least;
  double meant = value;
  if (span > 0 && logical > 0) meant = field.physical_least + (meant - field.least) / logical * span;
  const double unit = math::pow(10., std::abs(field.exponent));
  return field.exponent < 0 ? meant / unit : meant * unit;
}

double hid_millimetres(const HidField& field) {
  constexpr std::uint32_t centimetre = 0x11, inch = 0x13;
  return field.unit == centimetre ? 10 : field.unit == inch ? 25.4 : 0;
}

double hid_position(const HidField& field, std::int32_t value) {
  const double unit = hid_millimetres(field);
  return unit > 0 ? hid_physical(field, value) * unit : value;
}

float hid_share(const HidField& field, std::int32_t value) {
  return static_cast<float>(std::clamp((value - field.least) / (field.most - field.least), 0., 1.));
}

std::int32_t hid_value(const HidField& field, const HidReport& report) {
  std::uint64_t value = 0;
  const std::size_t first = field.bit / 8, last = (field.bit + field.bits - 1) / 8;
  for (std::size_t byte = first; byte <= last; ++byte)
    value |= std::uint64_t{report.bytes[byte]} << (8 * (byte - first));
  value = value >> field.bit % 8 & ((std::uint64_t{1} << field.bits) - 1);
  const bool negative = field.least < 0 && value >> (field.bits - 1) & 1;
  if (negative) value -= std::uint64_t{1} << field.bits;
  return static_cast<std::int32_t>(value);
}

}  // namespace burin
