// Reads the paths and polylines of SVG pictures, in the pixels of the picture, with the transforms around
// them. Each subpath is a stroke. A picture has no times, pressure or tilt; curves give chords, see
// svg_path.h.
#include <burin/base/error.h>
#include <burin/base/quoted_word.h>
#include <burin/ink/decode/svg_path.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/parse/scan.h>
#include <burin/ink/parse/xml.h>
#include <burin/ink/pen_file.h>
#include <burin/math/elementary.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
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
  } else {
    throw Error(fmt::format("a transform that is not known: {}", quoted_word(name)));
  }
  return made;
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
    std::string_view arguments = text.substr(open + 1, close - open - 1);
    std::vector<double> numbers;
    for (;;) {
      arguments.remove_prefix(std::min(arguments.find_first_not_of(" \t\r\n,"), arguments.size()));
      if (arguments.empty()) break;
      double number = 0;
      if (!take_number(arguments, number)) throw Error("a transform with what is no number");
      numbers.push_back(number);
    }
    all = all * transform_of(name, numbers);
    text.remove_prefix(close + 1);
  }
}

class SvgReader {
 public:
  explicit SvgReader(const PenFileText& file) : xml_(file) { content_.unit = "px"; }

  PenFile read() {
    read_element(xml_.root(), Affine::Identity());
    return std::move(content_);
  }

 private:
  void read_element(const pugi::xml_node& node, Affine transform);
  void add_path(std::string_view data, const Affine& transform);

  XmlFile xml_;
  PenFile content_;
};

/// Takes an element and those in it. What only serves others by reference is no stroke.
void SvgReader::read_element(const pugi::xml_node& node, Affine transform) {
  const std::string_view name = local_name(node.name());
  if (name == "defs" || name == "clipPath" || name == "symbol" || name == "marker" || name == "mask") return;
  try {
    transform = transform * parse_transform(attribute(node, "transform").value());
    if (name == "path") add_path(attribute(node, "d").value(), transform);
    if (name == "polyline" || name == "polygon") {
      const std::string points = attribute(node, "points").value();
      if (!points.empty()) add_path("M" + points + (name == "polygon" ? "Z" : ""), transform);
    }
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    xml_.reject(node, error.what());
  }
  for (const pugi::xml_node& child : node.children()) read_element(child, transform);
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
