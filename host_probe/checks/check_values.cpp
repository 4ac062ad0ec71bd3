// Checks texts and the values of parameters against what param.h and base.h promise.
#include "check_values.h"

#include <algorithm>
#include <cmath>

#include "../descriptors.h"
#include "../rules.h"

namespace burin_probe {
namespace {

/// The bytes that a character has by its first one; 0 for none.
int bytes_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

bool has_number(const burin_param_info& info) {
  return info.type >= BURIN_PARAM_FLOAT && info.type <= BURIN_PARAM_CHOICE;
}

std::uint32_t choices_of(const burin_param_info& info) {
  std::uint32_t count = 0;
  while (info.choices[count]) ++count;
  return count;
}

/// Whether a number is one that the parameter may have.
bool in_range(const burin_param_info& info, float value) {
  if (!std::isfinite(value)) return false;
  const bool whole = value == std::trunc(value);
  switch (info.type) {
    case BURIN_PARAM_BOOL:
      return value == 0 || value == 1;
    case BURIN_PARAM_CHOICE:
      return whole && value >= 0 && value < static_cast<float>(choices_of(info));
    case BURIN_PARAM_INT:
      return whole && value >= info.hard_min && value <= info.hard_max;
    default:
      return value >= info.hard_min && value <= info.hard_max;
  }
}

void check_numbers(const burin_param_info& info, const burin_floats& numbers, std::uint32_t nodes) {
  if (!expect(Rule::param_range, numbers.data, info.id)) return;
  const std::uint32_t different = numbers.stride == 0 ? 1 : nodes;
  for (std::uint32_t i = 0; i < different; ++i) {
    const float value = numbers.data[std::size_t{i} * numbers.stride];
    if (!in_range(info, value)) {
      expect(Rule::param_range, false, info.id, static_cast<double>(value));
      return;
    }
  }
  expect(Rule::param_range, true, info.id);
}

void check_colour(const burin_param_info& info, const burin_param_value& value) {
  for (const burin_floats& channel : value.colour)
    expect(Rule::param_range, channel.data && channel.data[0] >= 0 && channel.data[0] <= 1, info.id,
           channel.data ? static_cast<double>(channel.data[0]) : 0);
}

void check_knots(const burin_param_info& info, const burin_param_value& value) {
  if (!expect(Rule::param_curve, value.knots && value.knot_count > 0, info.id)) return;
  for (std::uint32_t i = 0; i < 2 * value.knot_count; ++i) {
    const bool rises = i % 2 == 1 || i < 2 || value.knots[i] > value.knots[i - 2];
    expect(Rule::param_curve, std::isfinite(value.knots[i]) && rises, info.id,
           static_cast<double>(value.knots[i]));
  }
}

void check_value(const burin_param_info& info, const burin_param_value& value, std::uint32_t nodes) {
  if (has_number(info)) check_numbers(info, value.number, nodes);
  if (info.type == BURIN_PARAM_COLOUR) check_colour(info, value);
  if (info.type == BURIN_PARAM_CURVE) check_knots(info, value);
  if (info.type == BURIN_PARAM_FILE || info.type == BURIN_PARAM_TEXT)
    expect(Rule::param_text, value.text && is_utf8(value.text), info.id);
}

}  // namespace

bool is_utf8(const char* text) {
  for (auto at = reinterpret_cast<const unsigned char*>(text); *at;) {
    const int bytes = bytes_of(*at);
    if (bytes == 0) return false;
    for (int i = 1; i < bytes; ++i)
      if ((at[i] & 0xC0) != 0x80) return false;
    at += bytes;
  }
  return true;
}

void check_text(const burin_text* text) {
  if (!text) return;
  expect(Rule::text_buffer, BURIN_HAS(text, burin_text, data) && (text->capacity == 0 || text->data),
         "capacity", text->capacity);
}

void check_params(const burin_params* params, std::uint32_t nodes) {
  const bool whole =
      params && params->struct_size >= sizeof *params && params->count == param_count && params->values;
  if (!expect(Rule::param_count, whole, "count", params ? params->count : 0)) return;
  for (std::uint32_t i = 0; i < param_count; ++i)
    check_value(*everything.params[i], params->values[i], nodes);
}

void check_single(const burin_params* params) {
  const std::uint32_t given = params && params->values ? std::min(params->count, param_count + 0U) : 0;
  for (std::uint32_t i = 0; i < given; ++i)
    expect(Rule::begin_numbers, params->values[i].number.stride == 0, everything.params[i]->id,
           params->values[i].number.stride);
}

void keep_numbers(Stroke& stroke, const burin_params& params) {
  for (std::uint32_t i = 0; i < std::min(params.count, param_count + 0U); ++i)
    if (has_number(*everything.params[i]) && params.values[i].number.data)
      stroke.numbers[i] = params.values[i].number.data[0];
}

void check_constant(const Stroke& stroke, const burin_params& params, std::uint32_t nodes) {
  for (std::uint32_t i = 0; i < param_count; ++i) {
    const burin_param_info& info = *everything.params[i];
    const burin_floats& numbers = params.values[i].number;
    if (info.dynamic || !has_number(info) || !numbers.data) continue;
    const std::uint32_t different = numbers.stride == 0 ? 1 : nodes;
    for (std::uint32_t node = 0; node < different; ++node) {
      const float value = numbers.data[std::size_t{node} * numbers.stride];
      if (value != stroke.numbers[i])
        expect(Rule::param_constant, false, info.id, static_cast<double>(value));
    }
    expect(Rule::param_constant, numbers.data[0] == stroke.numbers[i], info.id);
  }
}

}  // namespace burin_probe
