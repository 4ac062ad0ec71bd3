#pragma once
#include <concepts>
#include <initializer_list>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace burin {

/// The value of a brush parameter in files and settings: a bool, a number of any type, a text (a text, file
/// path or choice), or a list of numbers (the four of a colour, or x0 y0 x1 y1 ... of a curve).
struct ParamSetting : std::variant<bool, double, std::string, std::vector<double>> {
  using variant::variant;
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool>) ParamSetting(Whole number) : variant(static_cast<double>(number)) {}
  ParamSetting(std::initializer_list<double> numbers) : variant(std::vector<double>(numbers)) {}  ///< a list
};
using ParamSettings = std::map<std::string, ParamSetting>;

}  // namespace burin
