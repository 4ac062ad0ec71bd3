// Reads the paths, lines and polylines of SVG pictures, in the pixels of the picture, with the transforms and
// views around them. Each subpath is a stroke. A picture has no times, pressure or tilt; curves give chords,
// see svg_path.h.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/svg_path.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/xml.h>
#include <burin/ink/pen_file.h>
#include <burin/math/elementary.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Affine = Eigen::Affine2d;

/// One of the functions of a transform, "rotate" for instance.
Affine transform_of(std::string_view name, const std::vector<double>& n) {
  constexpr double degree = std::numbers::pi / 180;
  Affine made = Affine::Identity();
  if (name == "matrix" && n.size() == 6) {
    made.matrix() << n[0], n[2], n[4], n[1], n[3], n[5], 0, 0, 1;
  } else if (name == "translate" && (n.size() == 1 || n.size() == 2)) {
    made.translate(Eigen::Vector2d(n[0], n.size() == 2 ? n[1] : 0));
  } else if (name == "scale" && (n.size() == 1 || n.size() == 2)) {
    made.scale(Eigen::Vector2d(n[0], n.back()));
  } else if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
    const Eigen::Vector2d centre = n.size() == 3 ? Eigen::Vector2d(n[1], n[2]) : Eigen::Vector2d::Zero();
    const double cos = math::cos(n[0] * degree), sin = math::sin(n[0] * degree);
    made.linear() << cos, -sin, sin, cos;
    made.translation() = centre - made.linear() * centre;
  } else if ((name == "skewX" || name == "skewY") && n.size() == 1) {
    const double slope = math::tan(n[0] * degree);
    made.linear()(name == "skewX" ? 0 : 1, name == "skewX" ? 1 : 0) = slope;
  } else {
    throw Error(fmt::format("a transform that is not known: {}", quoted_word(name)));
  }
  return made;
}

/// Numbers between blanks and commas, up to the end of a text. Throws Error for anything else.
std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
    if (text.empty()) return numbers;
    double number = 0;
    if (!take_number(text, number))
      throw Error(fmt::format("expected a number, found {}", quoted_word(text.substr(0, 20))));
    numbers.push_back(number);
  }
}

/// All functions of a transform attribute.
Affine parse_transform(std::string_view text) {
  Affine all = Affine::Identity();
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
    if (text.empty()) return all;
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == text.npos || close == text.npos || close < open)
      throw Error("a transform without its brackets");
    const std::string_view name = text.substr(0, std::min(text.find_first_of(" \t\r\n("), open));
    all = all * transform_of(name, numbers_of(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
}

/// A length in pixels; nothing if it is a share of what is around, or none.
std::optional<double> pixels(std::string_view length) {
  struct Unit {
    std::string_view name;
    double pixels;
  };
  static constexpr std::array units = {Unit{"", 1},           Unit{"px", 1},         Unit{"in", 96},
                                       Unit{"cm", 96 / 2.54}, Unit{"mm", 96 / 25.4}, Unit{"pt", 96. / 72},
                                       Unit{"pc", 16},        Unit{"Q", 96 / 101.6}};
  double number = 0;
  skip_blanks(length);
  if (!take_number(length, number)) return std::nullopt;
  length = length.substr(0, length.find_last_not_of(blanks) + 1);
  const auto unit = std::ranges::find(units, length, &Unit::name);
  return unit == units.end() ? std::nullopt : std::optional(number * unit->pixels);
}

/// Where preserveAspectRatio has one axis: at the start, the middle or the end of what is left over.
double share_before(std::string_view aspect, char axis) {
  const auto has = [&](std::string_view end) {
    return aspect.find(std::string(1, axis) + std::string(end)) != aspect.npos;
  };
  return has("Min") ? 0 : has("Max") ? 1 : 0.5;
}

/// Maps the viewBox of an `svg` element to its place (section 8.2). Without either it is the identity.
Affine view_of(const pugi::xml_node& svg) {
  Affine view = Affine::Identity();
  view.translate(Eigen::Vector2d(pixels(attribute(svg, "x").value()).value_or(0),
                                 pixels(attribute(svg, "y").value()).value_or(0)));
  const auto width = pixels(attribute(svg, "width").value()),
             height = pixels(attribute(svg, "height").value());
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
  return take_word(value);
}

class SvgReader {
 public:
  explicit SvgReader(const PenFileText& file) : xml_(file) { content_.unit = "px"; }

  PenFile read() {
    read_element(xml_.root(), Affine::Identity(), true);
    return std::move(content_);
  }

 private:
  void read_element(const pugi::xml_node& node, Affine transform, bool visible);
  void add_shape(const pugi::xml_node& node, const Affine& transform);
  void add_path(std::string_view data, const Affine& transform);

  XmlFile xml_;
  PenFile content_;
};

/// Takes an element and those in it. What only serves others by reference is no stroke. `visible`: unless the
/// element says otherwise.
void SvgReader::read_element(const pugi::xml_node& node, Affine transform, bool visible) {
  const std::string_view name = local_name(node.name());
  if (property_of(node, "display") == "none") return;
  if (const std::string_view own = property_of(node, "visibility"); !own.empty() && own != "inherit")
    visible = own == "visible";
  if (name == "defs" || name == "clipPath" || name == "symbol" || name == "marker" || name == "mask" ||
      name == "pattern")
    return;
  try {
    transform = transform * parse_transform(attribute(node, "transform").value());
    if (name == "svg") transform = transform * view_of(node);
    if (visible) add_shape(node, transform);
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    xml_.reject(node, error.what());
  }
  for (const pugi::xml_node& child : node.children()) read_element(child, transform, visible);
}

void SvgReader::add_shape(const pugi::xml_node& node, const Affine& transform) {
  const std::string_view name = local_name(node.name());
  if (name == "path") add_path(attribute(node, "d").value(), transform);
  if (name == "polyline" || name == "polygon") {
    const std::string points = attribute(node, "points").value();
    if (!points.empty()) add_path("M" + points + (name == "polygon" ? "Z" : ""), transform);
  }
  if (name == "line") {
    const auto end = [&](const char* axis) { return pixels(attribute(node, axis).value()).value_or(0); };
    add_path(fmt::format("M{} {}L{} {}", end("x1"), end("y1"), end("x2"), end("y2")), transform);
  }
}

void SvgReader::add_path(std::string_view data, const Affine& transform) {
  follow_svg_path(
      data, [&] { content_.strokes.emplace_back(); },
      [&](const Eigen::Vector2d& point) {
        Sample& sample = content_.strokes.back().samples.emplace_back();
        sample.position.head<2>() = transform * point;
      });
}

}  // namespace

bool is_svg(std::string_view text) { return begins_with_element(text, "svg"); }

PenFile read_svg(const PenFileText& file) { return SvgReader(file).read(); }

}  // namespace burin
