#pragma once
#include <burin/base/text/json_value.h>
#include <burin/base/vector.h>
#include <burin/stroke/dynamics.h>
#include <burin/stroke/param_setting.h>
#include <burin/stroke/stroke_choices.h>
#include <burin/stroke/stroke_settings.h>
#include <burin/stroke/symmetry.h>

#include <array>
#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace burin {

// Values of settings from JSON and back. Readers throw FileError that names the place.

/// Finite as a float, in which brushes compute; so are the others.
double read_finite(const JsonValue& value);
double read_radius(const JsonValue& value);  ///< above 0
double read_not_negative(const JsonValue& value);
double read_share(const JsonValue& value);  ///< 0..1
Vec3d read_point(const JsonValue& value);   ///< [x, y, z], doubles
/// Truth, number, text or numbers.
ParamSetting read_param(const JsonValue& value);
ParamSettings read_params(const JsonValue& value);
std::vector<Dynamic> read_dynamics(const JsonValue& value);
/// "yes", "no", "auto", true or false.
Closure read_closure(const JsonValue& value);
/// "string:LENGTH" or "exponential:SECONDS".
Stabilising read_stabilising(const JsonValue& value);
/// "auto", "off" or "edge:LENGTH".
Refining read_refining(const JsonValue& value);
/// "-z,y": the axes that run along the stroke and up.
void read_axes(const JsonValue& value, AlongSettings& into);
/// "x", "yz" ...: sets these mirrors.
void read_mirrors(const JsonValue& value, Symmetry& into);

template <class Choice, std::size_t count>
Choice read_choice(const JsonValue& value, const std::array<Named<Choice>, count>& names) {
  std::map<std::string, Choice> choices;
  for (const auto& [name, choice] : names) choices.emplace(name, choice);
  return value.choice(choices);
}

/// Values of other types stand in no recording.
template <class T>
void json_of(const T& value) = delete;
nlohmann::ordered_json json_of(const std::string& text);
nlohmann::ordered_json json_of(const double& number);
nlohmann::ordered_json json_of(const Closure& closure);  ///< true, false or "auto"
nlohmann::ordered_json json_of(const ParamSettings& params);
nlohmann::ordered_json json_of(const std::vector<Dynamic>& dynamics);

}  // namespace burin
