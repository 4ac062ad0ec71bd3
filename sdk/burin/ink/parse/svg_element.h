#pragma once
#include <Eigen/Geometry>
#include <pugixml.hpp>
#include <string_view>

namespace burin {

/// Whether an element may be shown by what it demands of a viewer [SVG 2, section 5.9]: no extension, and a
/// language that is English, whose speaker the viewer is taken for.
bool svg_applies(const pugi::xml_node& node);

/// What an element says of a property that is one word, by its style or else by an attribute; empty if it
/// says nothing.
std::string_view svg_word(const pugi::xml_node& node, std::string_view property);

/// The transform of an element, about its origin. Throws Error for one that is malformed.
Eigen::Affine2d svg_transform_of(const pugi::xml_node& node);

/// Maps the viewBox of an `svg` or `symbol` element to its place [SVG 2, section 8.2]. Without either it is
/// the identity. `use`: that shows it and may tell another size; an empty one if none does.
Eigen::Affine2d svg_view(const pugi::xml_node& svg, const pugi::xml_node& use);

}  // namespace burin
