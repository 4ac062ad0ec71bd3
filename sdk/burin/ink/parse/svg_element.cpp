// What attributes and styles of an element of SVG say of whether and where it is shown.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/svg_element.h>
#include <burin/ink/parse/svg_transform.h>
#include <burin/ink/parse/xml.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace burin {
namespace {

using Affine = Eigen::Affine2d;

/// Where preserveAspectRatio has one axis: at the start, the middle or the end of what is left over.
double share_before(std::string_view aspect, char axis) {
  const auto has = [&](std::string_view end) {
    return aspect.find(std::string(1, axis) + std::string(end)) != aspect.npos;
  };
  return has("Min") ? 0 : has("Max") ? 1 : 0.5;
}

/// What an element says of a property, by its style or else by an attribute; empty if it says nothing.
std::string_view property_of(const pugi::xml_node& node, std::string_view name) {
  std::string_view value = attribute(node, name).value();
  for (std::string_view style = attribute(node, "style").value(); !style.empty();) {
    std::string_view declaration = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(declaration.size() + 1, style.size()));
    skip_blanks(declaration);
    if (!declaration.starts_with(name)) continue;
    declaration.remove_prefix(name.size());
    if (take_character(declaration, ':')) value = declaration;
  }
  return value;
}

/// The origin of an element's transform, that of the coordinates unless CSS says other. Behind one length CSS
/// takes the centre of what is shown for the other.
Eigen::Vector2d transform_origin(const pugi::xml_node& node) {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  std::string_view place = property_of(node, "transform-origin");
  place = place.substr(0, place.find("!important"));
  skip_blanks(place);
  if (place.empty()) return origin;
  const std::string quoted = quoted_word(place);
  for (double& coordinate : origin) {
    const auto known = pixels(take_word(place));
    if (!known) throw Error(fmt::format("a transform-origin that is not two lengths: {}", quoted));
    coordinate = *known;
  }
  return origin;
}

}  // namespace

bool svg_applies(const pugi::xml_node& node) {
  if (attribute(node, "requiredExtensions")) return false;
  const pugi::xml_attribute languages = attribute(node, "systemLanguage");
  if (!languages) return true;
  for (std::string_view rest = languages.value(); !rest.empty();) {
    std::string_view language = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(language.size() + 1, rest.size()));
    const std::string word = in_lower_case(std::string(take_word(language)));
    if (word == "en" || word.starts_with("en-")) return true;
  }
  return false;
}

std::string_view svg_word(const pugi::xml_node& node, std::string_view name) {
  std::string_view value = property_of(node, name);
  return take_word(value);
}

Eigen::Affine2d svg_transform_of(const pugi::xml_node& node) {
  std::string_view text = property_of(node, "transform");
  text = text.substr(0, text.find("!important"));
  std::string_view rest = text;
  const std::string_view word = take_word(rest);
  if (word.empty() || word == "none") return Affine::Identity();
  const Affine transform = parse_transform(text);
  const Eigen::Vector2d origin = transform_origin(node);
  return Eigen::Translation2d(origin) * transform * Eigen::Translation2d(-origin);
}

Eigen::Affine2d svg_view(const pugi::xml_node& svg, const pugi::xml_node& use) {
  Affine view = Affine::Identity();
  view.translate(Eigen::Vector2d(pixels(attribute(svg, "x").value()).value_or(0),
                                 pixels(attribute(svg, "y").value()).value_or(0)));
  const auto size = [&](const char* name) {
    const pugi::xml_attribute told = attribute(use, name);
    return pixels((told ? told : attribute(svg, name)).value());
  };
  const auto width = size("width"), height = size("height");
  const std::vector<double> box = numbers_of(attribute(svg, "viewBox").value());
  if (box.size() != 4 || !width || !height || !(box[2] > 0) || !(box[3] > 0)) return view;
  const std::string_view aspect = attribute(svg, "preserveAspectRatio").value();
  Eigen::Array2d scale(*width / box[2], *height / box[3]);
  if (aspect.find("none") == aspect.npos)
    scale = aspect.find("slice") == aspect.npos ? scale.minCoeff() : scale.maxCoeff();
  const Eigen::Array2d left_over = Eigen::Array2d(*width, *height) - scale * Eigen::Array2d(box[2], box[3]);
  view.translate((left_over * Eigen::Array2d(share_before(aspect, 'x'), share_before(aspect, 'Y'))).matrix());
  view.scale(scale.matrix());
  return view.translate(-Eigen::Vector2d(box[0], box[1]));
}

}  // namespace burin
