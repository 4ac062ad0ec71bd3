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

/// The rule that a parameter's ranges and default break; null if they break none.
constexpr const char* broken_by_ranges(const burin_param_info& info) {
  if (!(info.hard_min <= info.hard_max)) return "its hard range is empty";
  if (!finite(info.soft_min) || !finite(info.soft_max)) return "its soft range is not finite";
  if (!(info.soft_min <= info.soft_max)) return "its soft range is empty";
  if (!(info.hard_min <= info.soft_min && info.soft_max <= info.hard_max))
    return "its soft range is not within the hard range";
  if (!finite(info.default_number)) return "its default is not finite";
  if (!(info.hard_min <= info.default_number && info.default_number <= info.hard_max))
    return "its default is not within the hard range";
  return nullptr;
}

/// Whether a budget is a number from 0 on.
constexpr bool promises(double budget) { return budget >= 0 && budget <= std::numeric_limits<double>::max(); }

/// Whether x is a whole number within the range in which floats hold all whole numbers.
constexpr bool whole(float x) {
  constexpr float limit = 16777216;
  return -limit <= x && x <= limit && static_cast<float>(static_cast<int>(x)) == x;
}

constexpr const char* broken_by_whole_ranges(const burin_param_info& info) {
  for (const float end : {info.hard_min, info.hard_max, info.soft_min, info.soft_max})
    if (!whole(end)) return "an end of its ranges is no whole number within +-2^24";
  return broken_by_ranges(info);
}

constexpr bool different(const char* const* texts) {
  for (auto text = texts; *text; ++text)
    for (auto before = texts; before != text; ++before)
      if (std::string_view(*text) == *before) return false;
  return true;
}

constexpr const char* broken_by_choices(const burin_param_info& info) {
  if (!info.choices[0]) return "it has no choices";
  for (auto choice = info.choices; *choice; ++choice)
    if (!present(*choice)) return "a choice is empty";
  if (!different(info.choices)) return "two of its choices are equal";
  return broken_by_ranges(info) ? "its default is none of its choices" : nullptr;
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

constexpr const char* broken_by_value(const burin_param_info& info) {
  switch (info.type) {
    case BURIN_PARAM_INT:
      return broken_by_whole_ranges(info);
    case BURIN_PARAM_FLOAT:
    case BURIN_PARAM_BOOL:
      return broken_by_ranges(info);
    case BURIN_PARAM_CHOICE:
      return broken_by_choices(info);
    case BURIN_PARAM_COLOUR:
      return shares(info.default_colour) ? nullptr : "its colour is not within 0..1";
    case BURIN_PARAM_CURVE:
      return rising(info.default_knots, info.default_knot_count)
                 ? nullptr
                 : "it has no knots, or their x does not rise, or one is not finite";
    default:
      return nullptr;
  }
}

/// The rule that a parameter breaks by itself; null if it breaks none.
constexpr const char* broken_by(const burin_param_info& info) {
  if (!present(info.id)) return "it has no id";
  if (!only(info.id, "abcdefghijklmnopqrstuvwxyz0123456789_")) return "its id is not of a-z, 0-9 and _";
  if (!present(info.name)) return "it has no name";
  return broken_by_value(info);
}

/// The rule that parameter `i` breaks; null if it breaks none.
template <std::size_t N>
constexpr const char* broken_by(const std::array<burin_param_info, N>& infos, std::size_t i) {
  if (const char* rule = broken_by(infos[i])) return rule;
  for (std::size_t j = 0; j < i; ++j)
    if (std::string_view(infos[i].id) == infos[j].id) return "its id is that of another parameter";
  return nullptr;
}

/// The beginning of a text, as an argument of templates.
struct Text {
  constexpr explicit Text(const char* text) {
    for (std::size_t i = 0; text && text[i] && i + 1 < sizeof characters; ++i) characters[i] = text[i];
  }
  char characters[80]{};
};

/// Not constexpr, so that calling it in a constant expression is an error of compilation.
void mistake();

/// Fails to compile if a rule is broken. The parameter's id and the rule are arguments twice, since GCC's
/// errors show those of templates and Clang's those of functions.
template <Text parameter, Text rule>
constexpr bool parameter_keeps_rules(const char* /*id*/, const char* broken_rule) {
  if (broken_rule) mistake();
  return true;
}

constexpr bool all_differ(std::initializer_list<std::string_view> ids) {
  for (auto id = ids.begin(); id != ids.end(); ++id)
    if (std::find(ids.begin(), id, *id) != id) return false;
  return true;
}

}  // namespace burin::plugin::checks
