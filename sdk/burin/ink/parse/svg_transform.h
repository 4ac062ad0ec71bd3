#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

namespace burin {

/// Numbers between blanks and commas, up to the end of a text. Throws Error for anything else.
std::vector<double> numbers_of(std::string_view text);

/// A length in pixels; nothing if it is a share of what is around, or none.
std::optional<double> pixels(std::string_view length);

/// All functions of a transform: of the attribute of SVG, or of the property of CSS, whose numbers have
/// units. Throws Error for what is neither, for transforms in space and for shares of what is around.
Eigen::Affine2d parse_transform(std::string_view text);

}  // namespace burin
