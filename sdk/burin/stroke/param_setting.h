#pragma once
#include <concepts>
#include <initializer_list>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace burin {

/// A brush parameter as files and scripts give it: bool, number of any type, text (file path or choice), or
/// numbers (a colour's four, a curve's x0 y0 x1 y1 ...).
struct ParamSetting : std::variant<bool, double, std::string, std::vector<double>> {
  using variant::variant;
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool>) ParamSetting(Whole number) : variant(static_cast<double>(number)) {}
  ParamSetting(std::initializer_list<double> numbers) : variant(std::vector<double>(numbers)) {}
};
using ParamSettings = std::map<std::string, ParamSetting>;

}  // namespace burin
