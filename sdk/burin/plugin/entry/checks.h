#pragma once
#include <burin/abi/param.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string_view>

/// Checks of a brush's declarations at compile time, so that a host never has to refuse them.
namespace burin::plugin::checks {

constexpr bool present(const char* text) { return text && *text; }

constexpr bool only(std::string_view text, std::string_view allowed) {
  return !text.empty() && text.find_first_not_of(allowed) == std::string_view::npos;
}

/// Whether an id is in reverse DNS order, as "org.example.ripple": letters, digits, - and _ separated by
/// dots.
constexpr bool reverse_dns(const char* id) {
  if (!present(id)) return false;
  const std::string_view text = id;
  constexpr std::string_view characters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  return only(text, characters) && text.find('.') != text.npos && text.find("..") == text.npos &&
         text.front() != '.' && text.back() != '.';
}

constexpr bool finite(float x) {
  return x >= std::numeric_limits<float>::lowest() && x <= std::numeric_limits<float>::max();
}

/// Whether the default and the soft range are finite and within the hard range.
constexpr bool ranges(const burin_param_info& info) {
  return info.hard_min <= info.soft_min && info.soft_min <= info.soft_max && info.soft_max <= info.hard_max &&
         finite(info.soft_min) && finite(info.soft_max) && info.hard_min <= info.default_number &&
         info.default_number <= info.hard_max && finite(info.default_number);
}

/// Whether x is a whole number within the range in which floats hold all whole numbers.
constexpr bool whole(float x) {
  constexpr float limit = 16777216;
  return -limit <= x && x <= limit && static_cast<float>(static_cast<int>(x)) == x;
}

constexpr bool whole_ranges(const burin_param_info& info) {
  return whole(info.hard_min) && whole(info.hard_max) && whole(info.soft_min) && whole(info.soft_max);
}

constexpr bool different(const char* const* texts) {
  for (auto text = texts; *text; ++text)
    for (auto before = texts; before != text; ++before)
      if (!present(*text) || std::string_view(*text) == *before) return false;
  return true;
}

constexpr bool shares(const float (&channels)[4]) {
  return std::all_of(channels, channels + 4, [](float x) { return x >= 0 && x <= 1; });
}

/// Whether there are knots (x, y), all finite, with increasing x.
constexpr bool rising(const float* knots, std::size_t count) {
  for (std::size_t i = 0; i < 2 * count; ++i)
    if (!finite(knots[i]) || (i >= 2 && i % 2 == 0 && !(knots[i - 2] < knots[i]))) return false;
  return count > 0;
}

constexpr bool param(const burin_param_info& info) {
  if (!present(info.id) || !only(info.id, "abcdefghijklmnopqrstuvwxyz0123456789_") || !present(info.name))
    return false;
  switch (info.type) {
    case BURIN_PARAM_INT:
      return ranges(info) && whole_ranges(info);
    case BURIN_PARAM_FLOAT:
    case BURIN_PARAM_BOOL:
      return ranges(info);
    case BURIN_PARAM_CHOICE:
      return ranges(info) && different(info.choices);
    case BURIN_PARAM_COLOUR:
      return shares(info.default_colour);
    case BURIN_PARAM_CURVE:
      return rising(info.default_knots, info.default_knot_count);
    default:
      return true;
  }
}

constexpr bool all_differ(std::initializer_list<std::string_view> ids) {
  for (auto id = ids.begin(); id != ids.end(); ++id)
    if (std::find(ids.begin(), id, *id) != id) return false;
  return true;
}

/// Whether every parameter is well formed and every id is used once.
template <std::size_t N>
constexpr bool params(const std::array<burin_param_info, N>& infos) {
  for (std::size_t i = 0; i < N; ++i) {
    if (!param(infos[i])) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (std::string_view(infos[i].id) == infos[j].id) return false;
  }
  return true;
}

}  // namespace burin::plugin::checks
