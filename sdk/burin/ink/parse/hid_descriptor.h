#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

// Usages, page << 16 | usage, of pens and of touches.
inline constexpr std::uint32_t usage_x = 0x010030, usage_y = 0x010031, usage_tip = 0x0d0042,
                               usage_contact_id = 0x0d0051, usage_contact_count = 0x0d0054,
                               usage_pressure = 0x0d0030, usage_tilt_x = 0x0d003d, usage_barrel = 0x0d0044,
                               usage_eraser = 0x0d0045;

/// A field of the input reports of a HID device.
struct HidField {
  std::uint8_t report = 0;     ///< id of the report; 0 if the device has only one
  std::size_t bit = 0;         ///< from the first byte after the id
  unsigned bits = 0;           ///< 1..32
  std::uint32_t usage = 0;     ///< page << 16 | usage; Wacom's own pages as those of the standard
  double least = 0, most = 0;  ///< of the value, which is two's complement where `least` is negative
  double physical_least = 0, physical_most = 0;  ///< what these mean in `unit`; 0, 0: the same
  std::uint32_t unit =
      0;             ///< code of the HID specification; 0x11: cm, 0x12: radians, 0x13: in, 0x14: degrees
  int exponent = 0;  ///< of 10, on the unit
};

/// The variable input fields that a report descriptor describes. Throws Error for one that is cut off,
/// counts more bits than a report can have, or has more than 65,536 fields.
std::vector<HidField> hid_fields(std::span<const std::uint8_t> descriptor);

/// A report without the byte of its id.
struct HidReport {
  std::uint8_t id = 0;  ///< 0 if the device has only one report, which then has no such byte
  std::span<const std::uint8_t> bytes;

  bool has(const HidField& field) const { return field.bit + field.bits <= 8 * bytes.size(); }
};

/// Whether the reports of the device that has these fields begin with the byte of their id.
bool have_report_ids(std::span<const HidField> fields);

HidReport hid_report(std::span<const std::uint8_t> bytes, bool has_id);

/// What a value means: the physical range for the logical one, times the exponent.
double hid_physical(const HidField& field, std::int32_t value);

/// Millimetres in the unit of a field, or 0 if that is no length.
double hid_millimetres(const HidField& field);

/// A position in millimetres where the unit of the field is a length, else the value.
double hid_position(const HidField& field, std::int32_t value);

/// Where a value is in the logical range of its field, 0 to 1.
float hid_share(const HidField& field, std::int32_t value);

/// The value of a field in a report, which must have all bits of it.
std::int32_t hid_value(const HidField& field, const HidReport& report);

}  // namespace burin
