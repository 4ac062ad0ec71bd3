// Reads the values of stroke settings from JSON and checks their ranges; writes those that recordings hold.
#include <burin/stroke/files/recording_faults.h>
#include <burin/stroke/files/setting_values.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

namespace burin {

using Json = nlohmann::ordered_json;

double read_finite(const JsonValue& value) {
  const double number = value.number();
  if (!std::isfinite(static_cast<float>(number))) value.reject("is too large");
  return number;
}

double read_radius(const JsonValue& value) {
  const double radius = value.positive();
  if (static_cast<float>(radius) == 0) value.reject_type("a number above 0");
  return read_finite(value);
}

double read_not_negative(const JsonValue& value) {
  if (!(value.number() >= 0)) value.reject_type("a number from 0");
  return read_finite(value);
}

double read_share(const JsonValue& value) {
  if (const double share = value.number(); share >= 0 && share <= 1) return share;
  value.reject_type("a number from 0 to 1");
}

Vec3d read_point(const JsonValue& value) {
  const std::vector<double> numbers = value.is_array() ? value.numbers() : std::vector<double>();
  if (numbers.size() != 3) value.reject_type("three numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

ParamSetting read_param(const JsonValue& value) {
  if (value.is_boolean()) return value.boolean();
  if (value.is_text()) return value.text();
  if (value.is_array()) return value.numbers();
  return value.number();
}

ParamSettings read_params(const JsonValue& value) {
  ParamSettings settings;
  for (const auto& [name, setting] : value.members()) settings[name] = read_param(setting);
  return settings;
}

namespace {

Dynamic read_dynamic(const JsonValue& value) {
  const JsonValue source = value.member("source");
  const auto known = parse_source(source.text());
  if (!known) source.reject_type("one of " + source_names());
  const Dynamic dynamic{value.member("target").text(), *known, value.member("curve").numbers()};
  if (const std::string_view fault = validation_error(dynamic); !fault.empty()) value.reject(fault);
  return dynamic;
}

}  // namespace

std::vector<Dynamic> read_dynamics(const JsonValue& value) {
  std::vector<Dynamic> dynamics;
  for (const JsonValue& item : value.items()) dynamics.push_back(read_dynamic(item));
  return dynamics;
}

Closure read_closure(const JsonValue& value) {
  if (value.is_boolean()) return value.boolean() ? Closure::closed : Closure::open;
  return read_choice(value, named_closures);
}

Stabilising read_stabilising(const JsonValue& value) {
  const std::string text = value.is_text() ? value.text() : "";
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view kind = std::string_view(text).substr(0, colon);
  double amount = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + std::min(colon + 1, text.size()), end, amount);
  const bool sound = error == std::errc() && stop == end && amount > 0 && std::isfinite(amount);
  if (!sound || (kind != "string" && kind != "exponential"))
    value.reject_type("string:LENGTH or exponential:SECONDS, above 0");
  return {kind == "string" ? Stabilising::Kind::string : Stabilising::Kind::exponential, amount};
}

Refining read_refining(const JsonValue& value) {
  const std::string text = value.is_text() ? value.text() : "";
  if (text == "off") return {};
  if (text == "auto") return {.kind = Refining::Kind::automatic};
  constexpr std::string_view prefix = "edge:";
  const bool is_edge = text.starts_with(prefix);
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (is_edge ? prefix.size() : 0), end, number);
  const bool is_number = error == std::errc() && stop == end;
  if (is_edge && is_number && std::isfinite(static_cast<float>(number)) && static_cast<float>(number) > 0)
    return {.kind = Refining::Kind::edge, .edge = number};
  if (!is_edge && is_number && number >= Refining::least_error && number <= Refining::most_error)
    return {.kind = Refining::Kind::error, .error = number};
  value.reject_type(fmt::format("auto, off, edge:LENGTH, above 0, or an error from {:g} to {:g}",
                                Refining::least_error, Refining::most_error));
}

namespace {

/// "x", "-y" ...; none for anything else.
std::optional<Vec3d> parse_axis(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (text.size() != 1 || text[0] < 'x' || text[0] > 'z') return {};
  return (negative ? -1 : 1) * Vec3d::Unit(text[0] - 'x');
}

}  // namespace

void read_axes(const JsonValue& value, AlongSettings& into) {
  const std::string text = value.is_text() ? value.text() : "";
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto forward = parse_axis(std::string_view(text).substr(0, comma)),
             up = parse_axis(std::string_view(text).substr(std::min(comma + 1, text.size())));
  if (!forward || !up || forward->dot(*up) != 0) value.reject_type("two axes such as x,y or -z,y");
  into.forward = *forward;
  into.up = *up;
}

void read_mirrors(const JsonValue& value, Symmetry& into) {
  const std::string axes = value.text();
  if (axes.empty() || axes.find_first_not_of("xyz") != std::string::npos)
    value.reject_type("x, y, z or several of them");
  into.mirror_x = axes.find('x') != std::string::npos;
  into.mirror_y = axes.find('y') != std::string::npos;
  into.mirror_z = axes.find('z') != std::string::npos;
}

Json json_of(const std::string& text) { return text; }
Json json_of(const double& number) { return number; }

Json json_of(const Closure& closure) {
  if (closure == Closure::automatic) return name_of(named_closures, closure);
  return closure == Closure::closed;
}

Json json_of(const ParamSettings& params) {
  Json all = Json::object();
  for (const auto& [id, setting] : params)
    std::visit([&, &name = id](const auto& value) { all[name] = value; }, setting);
  return all;
}

Json json_of(const std::vector<Dynamic>& dynamics) {
  Json all = Json::array();
  for (const Dynamic& dynamic : dynamics)
    all.push_back(
        {{"target", dynamic.target}, {"source", source_name(dynamic.source)}, {"curve", dynamic.curve}});
  return all;
}

}  // namespace burin
