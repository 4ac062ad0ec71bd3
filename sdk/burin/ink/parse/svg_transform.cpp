// Parses transforms of SVG [SVG 1.1, section 7.6] and of CSS [CSS Transforms 1], which has more functions,
// and units behind numbers.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/svg_transform.h>
#include <burin/math/degree.h>
#include <burin/math/elementary.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <span>
#include <string>

namespace burin {
namespace {

using Affine = Eigen::Affine2d;

struct Unit {
  std::string_view name;
  double scale;  ///< to pixels or degrees
};

constexpr std::array lengths = {Unit{"", 1},           Unit{"px", 1},         Unit{"in", 96},
                                Unit{"cm", 96 / 2.54}, Unit{"mm", 96 / 25.4}, Unit{"pt", 96. / 72},
                                Unit{"pc", 16},        Unit{"Q", 96 / 101.6}};
constexpr std::array angles = {Unit{"", 1}, Unit{"deg", 1}, Unit{"rad", 180 / std::numbers::pi},
                               Unit{"grad", 0.9}, Unit{"turn", 360}};
constexpr std::array none = {Unit{"", 1}};

/// Removes a number and its unit from the front of a text; nothing if the unit is not one of these.
std::optional<double> take_in_units(std::string_view& text, std::span<const Unit> units) {
  double number = 0;
  skip_blanks(text);
  if (!take_number(text, number)) return std::nullopt;
  std::size_t end = 0;
  while (end < text.size() && (std::isalpha(static_cast<unsigned char>(text[end])) || text[end] == '%'))
    ++end;
  const auto unit = std::ranges::find(units, text.substr(0, end), &Unit::name);
  text.remove_prefix(end);
  return unit == units.end() ? std::nullopt : std::optional(number * unit->scale);
}

std::string_view behind_commas(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
  return text;
}

/// The arguments of a function in the units that its name asks for.
std::vector<double> arguments_of(std::string_view name, std::string_view text) {
  const bool turns = name.starts_with("rotate") || name.starts_with("skew"),
             moves = name.starts_with("translate");
  std::span<const Unit> units = none;
  if (turns) units = angles;
  if (moves) units = lengths;
  std::vector<double> numbers;
  for (text = behind_commas(text); !text.empty(); text = behind_commas(text)) {
    const std::string_view word = text.substr(0, 20);
    // Behind the angle of SVG's rotate() are the coordinates of its centre.
    const auto number =
        take_in_units(text, name == "rotate" && !numbers.empty() ? std::span(lengths) : units);
    if (!number) throw Error(fmt::format("expected a number, found {}", quoted_word(word)));
    numbers.push_back(*number);
  }
  return numbers;
}

Affine rotation(const std::vector<double>& n) {
  const Eigen::Vector2d centre = n.size() == 3 ? Eigen::Vector2d(n[1], n[2]) : Eigen::Vector2d::Zero();
  const double cos = math::cos(n[0] * math::degree), sin = math::sin(n[0] * math::degree);
  Affine made = Affine::Identity();
  made.linear() << cos, -sin, sin, cos;
  made.translation() = centre - made.linear() * centre;
  return made;
}

Affine skewing(double x, double y) {
  Affine made = Affine::Identity();
  made.linear() << 1, math::tan(x * math::degree), math::tan(y * math::degree), 1;
  return made;
}

/// One of the functions of a transform, "rotate" for instance.
Affine function_of(std::string_view name, const std::vector<double>& n) {
  const bool one = n.size() == 1, one_or_two = one || n.size() == 2;
  Affine made = Affine::Identity();
  if (name == "matrix" && n.size() == 6) {
    made.matrix() << n[0], n[2], n[4], n[1], n[3], n[5], 0, 0, 1;
    return made;
  }
  if (name == "translate" && one_or_two) return made.translate(Eigen::Vector2d(n[0], one ? 0 : n[1]));
  if (name == "translateX" && one) return made.translate(Eigen::Vector2d(n[0], 0));
  if (name == "translateY" && one) return made.translate(Eigen::Vector2d(0, n[0]));
  if (name == "scale" && one_or_two) return made.scale(Eigen::Vector2d(n[0], n.back()));
  if (name == "scaleX" && one) return made.scale(Eigen::Vector2d(n[0], 1));
  if (name == "scaleY" && one) return made.scale(Eigen::Vector2d(1, n[0]));
  if (name == "rotate" && (one || n.size() == 3)) return rotation(n);
  if (name == "skew" && one_or_two) return skewing(n[0], one ? 0 : n[1]);
  if (name == "skewX" && one) return skewing(n[0], 0);
  if (name == "skewY" && one) return skewing(0, n[0]);
  throw Error(fmt::format("a transform that is not known: {}", quoted_word(name)));
}

}  // namespace

std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (text = behind_commas(text); !text.empty(); text = behind_commas(text)) {
    const std::string_view word = text.substr(0, 20);
    if (!take_number(text, numbers.emplace_back()))
      throw Error(fmt::format("expected a number, found {}", quoted_word(word)));
  }
  return numbers;
}

std::optional<double> pixels(std::string_view length) {
  const auto found = take_in_units(length, lengths);
  skip_blanks(length);
  return length.empty() ? found : std::nullopt;
}

Affine parse_transform(std::string_view text) {
  Affine all = Affine::Identity();
  for (text = behind_commas(text); !text.empty(); text = behind_commas(text)) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == text.npos || close == text.npos || close < open)
      throw Error("a transform without its brackets");
    const std::string_view name = text.substr(0, std::min(text.find_first_of(" \t\r\n("), open));
    all = all * function_of(name, arguments_of(name, text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
  return all;
}

}  // namespace burin
